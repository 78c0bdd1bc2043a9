#include "nacre/solver/rough_interface_operators.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nacre/core/dense.h"
#include "nacre/core/lru_cache.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"

namespace nacre::solver {

namespace {

using Matrix = RowMajorMatrix;
using Vector = Eigen::VectorXd;

// Polynomials P_m(x) of a number of x, one row for each m. Row 0 is given, and scales the others;
// P_m = a_m x P_(m-1) - b_m P_(m-2), where step(m) is {a_m, b_m}.
template <class Step>
void add_polynomials(const double* x, Matrix& rows, Step&& step) {
    for (int m = 1; m < rows.rows(); ++m) {
        const auto [a, b] = step(m);
        const double* const last = rows.row(m - 1).data();
        const double* const before = rows.row(std::max(m - 2, 0)).data();
        double* const now = rows.row(m).data();
        for (int k = 0; k < rows.cols(); ++k) now[k] = a * x[k] * last[k] - b * before[k];
    }
}

// Legendre's, by Bonnet's recurrence.                       [abramowitz-stegun-1964, 8.5.3]
void add_legendre(const double* x, Matrix& rows) {
    add_polynomials(x, rows, [](double m) { return std::pair{(2 * m - 1) / m, (m - 1) / m}; });
}

// Chebyshev's, cos(m phi) of x = cos(phi).                     [abramowitz-stegun-1964, 22.7.4]
void add_chebyshev(const double* x, Matrix& rows) {
    add_polynomials(x, rows, [](int m) { return m == 1 ? std::pair{1, 0} : std::pair{2, 1}; });
}

// A panel of Directions: Gauss-Legendre nodes in its own angle, theta_e outside or the angle inside.
struct Panel {
    Panel(int first_node, const std::vector<double>& angle, double begin, double end)
        : first(first_node),
          count(static_cast<int>(angle.size())),
          from(begin),
          to(end),
          basis(angle),
          legendre(count, count) {
        const Quadrature rule = gauss_legendre(count, -1, 1);
        legendre.row(0).setOnes();
        add_legendre(rule.nodes.data(), legendre);
        for (int m = 0; m < count; ++m) {
            for (int j = 0; j < count; ++j) legendre(m, j) *= (m + 0.5) * rule.weights[j];
        }
    }

    int first, count;
    double from, to;
    ExitInterpolation basis;
    // [m][j]: the Lagrange polynomial of node j is the sum of these times P_m, as the rule is exact
    // for products of two.
    Matrix legendre;
};

// A node of the outer integral, on one panel and one side.
struct OuterNode {
    const Panel* panel;
    bool outside;
    double theta;                            // on its own side
    double etendue;                          // over 2 pi
    std::vector<double> basis;               // the panel's Lagrange polynomials here
    int orders;                              // that are not negligible
    std::vector<double> reflected, through;  // [order][node inside]: inner integral by node
    double masked = 1;
};

// Sums over exits to a panel of their fraction times cos(l phi) l_j(angle), l_j the Lagrange polynomials
// of its nodes: of Legendre's, for many exits at once, from which those follow at the end.
class ExitSums {
 public:
    ExitSums(const Panel& panel, int orders)
        : panel_(panel),
          waves_(orders, kBlock),
          legendre_(panel.count, kBlock),
          sums_(Matrix::Zero(orders, panel.count)) {}

    /// @param angle  the panel's
    void add(double fraction, double cos_phi, double angle) {
        waves_(0, count_) = fraction;
        cos_phi_[count_] = cos_phi;
        x_[count_] = 2 * (angle - panel_.from) / (panel_.to - panel_.from) - 1;
        if (++count_ == kBlock) add_block();
    }

    /// [order][node], when all exits have been added.
    Matrix by_node() {
        // Places of the last block that are not taken.
        waves_.row(0).tail(kBlock - count_).setZero();
        add_block();
        return product(sums_, panel_.legendre);
    }

 private:
    static constexpr int kBlock = 64;

    void add_block() {
        add_chebyshev(cos_phi_.data(), waves_);
        legendre_.row(0).setOnes();
        add_legendre(x_.data(), legendre_);
        add_product_with_transposed(sums_, waves_, legendre_);
        count_ = 0;
    }

    const Panel& panel_;
    Matrix waves_, legendre_;  // [order or degree][exit]
    Matrix sums_;              // [order][degree]
    std::array<double, kBlock> cos_phi_{}, x_{};
    int count_ = 0;
};

class Projection {
 public:
    Projection(const Directions& d, int orders, double alpha)
        : d_(d), orders_(orders), alpha_(alpha) {
        panels_.emplace_back(0, d.exit_angle, 0.0, kHorizon);
        if (d.size() > d.exit_count) {
            std::vector<double> angle;
            for (int i = d.exit_count; i < d.size(); ++i) angle.push_back(std::acos(d.mu[i]));
            panels_.emplace_back(d.exit_count, angle, std::asin(1 / d.ior), kHorizon);
        }
        const double n2 = d.ior * d.ior;
        for (int i = 0; i < d.size(); ++i) etendue_.push_back(n2 * d.weight[i] * d.mu[i]);
        add_outer_nodes(panels_[0], true);
        for (const Panel& panel : panels_) add_outer_nodes(panel, false);
        parallel_for(std::size_t{0}, outer_nodes_.size(),
                     [&](std::size_t i) { integrate_facets(outer_nodes_[i]); });
        set_normaliser();
    }

    // Reflection inside and transmission to outside (exits x size) of one order, all nodes.
    Matrix reflection(int l) const { return project(false, l, &OuterNode::reflected); }
    Matrix transmission(int l) const { return project(true, l, &OuterNode::through); }

    // Projection of a function given by its values at the outer nodes of one side.
    Vector project(bool outside, double OuterNode::*value) const {
        Vector out = Vector::Zero(outside ? d_.exit_count : d_.size());
        for (const OuterNode& s : outer_nodes_) {
            if (s.outside != outside) continue;
            for (int i = 0; i < s.panel->count; ++i) {
                out[s.panel->first + i] += s.etendue * s.basis[i] * (s.*value);
            }
        }
        for (int i = 0; i < out.size(); ++i) out[i] /= std::sqrt(etendue_[i]);
        return normaliser_.topLeftCorner(out.size(), out.size()) * out;
    }

    // The root mean square, over the etendue inside, of a function given by its projection there:
    // of the part of it that is a polynomial in the cosine, of as many terms for any number of nodes.
    double smooth_rms(const Vector& function) const {
        const Vector one = ones(false);
        const Eigen::Map<const Vector> mu(d_.mu.data(), d_.size());
        std::vector<Vector> smooth;  // orthonormal, of rising degree
        double sum = 0;
        const int terms = std::min(12, d_.exit_count);
        for (int degree = 0; degree < terms; ++degree) {
            Vector next = degree ? mu.cwiseProduct(smooth.back()).eval() : one;
            for (const Vector& lower : smooth) next -= lower.dot(next) * lower;
            smooth.push_back(next / next.norm());
            const double part = smooth.back().dot(function);
            sum += part * part;
        }
        return std::sqrt(sum) / one.norm();
    }

    // The projection of the function 1, which is exact.
    Vector ones(bool outside) const {
        Vector out(outside ? d_.exit_count : d_.size());
        for (int i = 0; i < out.size(); ++i) out[i] = std::sqrt(etendue_[i]);
        return out;
    }

 private:
    void add_outer_nodes(const Panel& panel, bool outside) {
        // Exact for products of two basis functions and a smooth third one. Beyond the critical
        // angle there are few nodes, and masking begins within its roughness of the horizon.
        const int more = panel.first == 0 ? 12 : 16;
        const Quadrature rule = gauss_legendre(panel.count + more, panel.from, panel.to);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            OuterNode s;
            s.panel = &panel;
            s.outside = outside;
            const double angle = rule.nodes[k];
            s.etendue = rule.weights[k] * std::sin(angle) * std::cos(angle);
            const bool exits = panel.first == 0;
            if (!exits) s.etendue *= d_.ior * d_.ior;
            s.theta = exits && !outside ? std::asin(std::sin(angle) / d_.ior) : angle;
            s.basis.resize(panel.count);
            panel.basis.weights_at(angle, s.basis.data());
            // Lobes are no narrower than alpha times (n - 1)/n, the deviation of a refracted ray
            // per tilt of the facet.
            const double narrowest = alpha_ * (d_.ior - 1) / d_.ior;
            s.orders =
                static_cast<int>(std::min<double>(orders_, 12 + 5 * std::sin(s.theta) / narrowest));
            outer_nodes_.push_back(std::move(s));
        }
    }

    void integrate_facets(OuterNode& s) const {
        const int n = d_.size();
        // The basis jumps from panel to panel at the critical angle.
        const double edge = panels_.size() > 1 ? std::sqrt(1 - 1 / (d_.ior * d_.ior)) : 0.0;
        const FacetDetail detail{2.0 * d_.exit_count / kHorizon, static_cast<double>(s.orders),
                                 edge};
        std::vector<ExitSums> sums;
        for (const Panel& panel : panels_) sums.emplace_back(panel, s.orders);
        const double here = s.outside ? 1.0 : d_.ior, there = s.outside ? d_.ior : 1.0;
        for_each_facet_exit(s.theta, alpha_, here, there, detail, [&](const FacetExits& exits) {
            s.masked -= lane_sum(exits.fraction);
            if (s.outside != exits.through) return;  // ends outside: closed form
            for (int i = 0; i < kLanes; ++i) {
                if (exits.fraction[i] < 1e-15) continue;
                // To the inside: which panel?
                const double sine_outside = d_.ior * exits.sine[i];
                const bool beyond = sine_outside >= 1 && panels_.size() > 1;
                sums[beyond].add(exits.fraction[i], exits.cos_phi[i],
                                 beyond ? std::atan2(exits.sine[i], exits.cosine[i])
                                        : std::asin(std::min(1.0, sine_outside)));
            }
        });
        std::vector<double>& values = s.outside ? s.through : s.reflected;
        values.resize(static_cast<std::size_t>(s.orders) * n);
        Eigen::Map<Matrix> by_node(values.data(), s.orders, n);
        for (std::size_t p = 0; p < panels_.size(); ++p) {
            by_node.middleCols(panels_[p].first, panels_[p].count) = sums[p].by_node();
        }
    }

    // Polynomials are orthogonal under the nodes' own quadrature, nearly so under the
    // true measure for the highest degrees: M^-1/2 makes them so.                [lowdin-1950]
    void set_normaliser() {
        const int n = d_.size();
        Matrix gram = Matrix::Zero(n, n);
        for (const OuterNode& s : outer_nodes_) {
            if (s.outside) continue;
            for (int i = 0; i < s.panel->count; ++i) {
                for (int j = 0; j < s.panel->count; ++j) {
                    const int a = s.panel->first + i, b = s.panel->first + j;
                    gram(a, b) +=
                        s.etendue * s.basis[i] * s.basis[j] / std::sqrt(etendue_[a] * etendue_[b]);
                }
            }
        }
        normaliser_ = inverse_square_root(gram);
    }

    Matrix project(bool outside, int l, std::vector<double> OuterNode::*values) const {
        const int n = d_.size(), rows = outside ? d_.exit_count : n;
        Matrix out = Matrix::Zero(rows, n);
        for (const OuterNode& s : outer_nodes_) {
            if (s.outside != outside || l >= s.orders) continue;
            const Eigen::Map<const Eigen::RowVectorXd> value(
                (s.*values).data() + std::size_t(l) * n, n);
            for (int i = 0; i < s.panel->count; ++i) {
                out.row(s.panel->first + i) += s.etendue * s.basis[i] * value;
            }
        }
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < n; ++j) out(i, j) /= std::sqrt(etendue_[i] * etendue_[j]);
        }
        return product(product(normaliser_.topLeftCorner(rows, rows), out), normaliser_);
    }

    const Directions& d_;
    int orders_;
    double alpha_;
    std::vector<Panel> panels_;
    std::vector<double> etendue_;  // of the nodes, over 2 pi
    std::vector<OuterNode> outer_nodes_;
    Matrix normaliser_;
};

std::vector<double> elements(const Matrix& m) { return {m.data(), m.data() + m.size()}; }

}  // namespace

RoughInterfaceOperators::RoughInterfaceOperators(const Directions& d, const ActiveNodes& active,
                                                 double alpha) {
    const Projection projection(d, active.orders(), alpha);
    orders_.resize(active.orders());
    parallel_for(0, active.orders(), [&](int l) {
        Matrix reflection = projection.reflection(l);
        reflection = 0.5 * (reflection + reflection.transpose()).eval();
        Matrix transmission = projection.transmission(l);
        if (l == 0) {
            // Masked light returns diffusely. Inside, m is the deficit of the matrices' sums, so
            // that they conserve energy to rounding.
            const Vector masked_outside = projection.project(true, &OuterNode::masked);
            const Vector masked_inside = projection.ones(false) -
                                         reflection * projection.ones(false) -
                                         transmission.transpose() * projection.ones(true);
            asymmetry_ = projection.smooth_rms(projection.project(false, &OuterNode::masked) -
                                               masked_inside);
            const double total = masked_outside.dot(projection.ones(true)) +
                                 masked_inside.dot(projection.ones(false));
            if (total > 0) {
                reflection += masked_inside * masked_inside.transpose() / total;
                transmission += masked_outside * masked_inside.transpose() / total;
            }
        }
        const int first = active.first(l);
        Order& out = orders_[l];
        out.n = d.size() - first;
        out.exits = std::max(0, d.exit_count - first);
        const Matrix r = reflection.bottomRightCorner(out.n, out.n);
        const Matrix t = transmission.bottomRightCorner(out.exits, out.n);
        const Matrix identity = Matrix::Identity(out.n, out.n);
        const Matrix q = inverse_of_positive_definite(identity + r);
        const Matrix through = product(t, q);
        out.impedance = elements(q + q.transpose() - identity);
        out.through = elements(through.transpose());
        out.direct = elements(product_with_transposed(through, t));
        out.enter = elements(t.transpose());
    });
}

std::size_t RoughInterfaceOperators::bytes() const {
    std::size_t numbers = 0;
    for (const Order& o : orders_) {
        numbers += o.impedance.size() + o.through.size() + o.direct.size() + o.enter.size();
    }
    return numbers * sizeof(double);
}

std::shared_ptr<const RoughInterfaceOperators> rough_interface_operators(
    const Directions& directions, const ActiveNodes& active, double alpha) {
    struct Nodes {
        Directions directions;
        ActiveNodes active;
        double alpha;
        bool operator==(const Nodes&) const = default;
    };
    static LruCache<Nodes, RoughInterfaceOperators> operators(
        std::size_t{64} << 20, [](const RoughInterfaceOperators& o) { return o.bytes(); });
    return operators.get({directions, active, alpha},
                         [&] { return RoughInterfaceOperators(directions, active, alpha); });
}

}  // namespace nacre::solver
