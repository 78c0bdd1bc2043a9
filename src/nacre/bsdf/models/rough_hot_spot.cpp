#include "nacre/bsdf/models/rough_hot_spot.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <vector>

#include "nacre/bsdf/models/hot_spot_block.h"
#include "nacre/bsdf/models/hot_spot_compensation.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/solver/lane_registers.h"
#include "nacre/solver/rough_interface.h"

namespace nacre::bsdf {
namespace {

/// A tensor at its exit nodes, uncompressed: [order][pair i >= j from first[order]][wavelength].
class NodeValues {
 public:
    /// @param filled  with its values, or with 0
    explicit NodeValues(const solver::MultipleScattering& tensor, bool filled = true)
        : tensor_(tensor), wavelengths_(tensor.wavelength_count) {
        std::size_t pairs = 0;
        for (const int first : tensor.first) {
            offset_.push_back(pairs);
            pairs += solver::triangle(tensor.exit_angle.size() - first);
        }
        values_.assign(pairs * wavelengths_, 0.0);
        if (!filled) return;
        parallel_for(std::size_t{0}, pairs, [&](std::size_t pair) {
            double* const row = &values_[pair * wavelengths_];
            for (int k = 0; k < tensor.rank(); ++k) {
                const double c = tensor.coefficient[k * pairs + pair];
                const float* const basis = &tensor.basis[k * wavelengths_];
                for (int w = 0; w < wavelengths_; ++w) row[w] += c * basis[w];
            }
        });
    }

    int orders() const { return tensor_.orders(); }
    /// At all wavelengths; null where the order has no such pair.
    double* at(int order, int i, int j) {
        const int first = tensor_.first[order];
        if (std::min(i, j) < first) return nullptr;
        const auto pair = solver::triangle(std::max(i, j) - first) + std::min(i, j) - first;
        return &values_[(offset_[order] + pair) * wavelengths_];
    }
    std::vector<double*> rows(int i, int j) {
        std::vector<double*> rows;
        for (int l = 0; l < orders(); ++l) rows.push_back(at(l, i, j));
        return rows;
    }
    solver::MultipleScattering compressed(double tolerance) const {
        return solver::compress(tensor_.exit_angle, tensor_.first, wavelengths_, values_,
                                tolerance);
    }

 private:
    const solver::MultipleScattering& tensor_;
    int wavelengths_;
    std::vector<std::size_t> offset_;
    std::vector<double> values_;
};

// Products with a function of the azimuth, of values by order.
class Azimuths {
 public:
    /// Half a turn, so finely that a product with a factor of some 30 orders is exact.
    explicit Azimuths(int orders)
        : count_((orders + 16 + 3) / 4 * 4), stride_((orders + 1) / 2 * 2) {
        for (int m = 0; m < count_; ++m) {
            // From the mirror side, as the orders' cosines are.
            phi_.push_back(std::numbers::pi + turn(m));
        }
        for (int m = 0; m < count_ / 2; ++m) {
            for (int l = 0; l < stride_; ++l) cosine_.push_back(std::cos(l * turn(m)));
        }
    }
    const std::vector<double>& phi() const { return phi_; }

    /// @param rows    by order, of `width` values each; null: 0, and stays 0
    /// @param factor  [azimuth][block of eight values]
    void multiply(const std::vector<double*>& rows, const std::vector<FloatLanes>& factor,
                  std::size_t width) const {
        const std::size_t blocks = factor.size() / phi_.size();
        thread_local std::vector<DoubleLanes> in, out;
        for (std::size_t b = 0; b < blocks; ++b) {
            const std::size_t bytes =
                std::min<std::size_t>(width - b * kLanes, kLanes) * sizeof(double);
            in.assign(stride_, DoubleLanes{});
            for (std::size_t l = 0; l < rows.size(); ++l) {
                if (rows[l]) std::memcpy(&in[l], rows[l] + b * kLanes, bytes);
                if (l > 0) in[l] += in[l];
            }
            out.assign(stride_, DoubleLanes{});
            multiply(in.data(), factor.data() + b, blocks, out.data(),
                     static_cast<int>(rows.size() + 1) / 2 * 2);
            for (std::size_t l = 0; l < rows.size(); ++l) {
                if (rows[l]) std::memcpy(rows[l] + b * kLanes, &out[l], bytes);
            }
        }
    }

 private:
    double turn(int m) const { return std::numbers::pi * (m + 0.5) / count_; }

    /// By turns about a quarter that mirror each other: even orders are the same at both, odd ones the
    /// opposite. Two pairs at once, whose sums do not wait for each other.
    void multiply(const DoubleLanes* in, const FloatLanes* factor, std::size_t blocks,
                  DoubleLanes* out, int orders) const {
        using solver::load, solver::store;
        const double part_of_turn = 1.0 / count_;
        for (int m = 0; m < count_ / 2; m += 2) {
            const double *c = &cosine_[static_cast<std::size_t>(m) * stride_], *d = c + stride_;
            const auto at = [&](int azimuth) {
                return part_of_turn * to_double(factor[azimuth * blocks]);
            };
            const DoubleLanes c1 = at(m), c2 = at(count_ - 1 - m), d1 = at(m + 1),
                              d2 = at(count_ - 2 - m);
            for (int part = 0; part < solver::kRegisters; ++part) {
                solver::Register even_c{}, odd_c{}, even_d{}, odd_d{};
                for (int l = 0; l < orders; l += 2) {
                    const solver::Register even = load(in + l, part), odd = load(in + l + 1, part);
                    even_c += c[l] * even;
                    odd_c += c[l + 1] * odd;
                    even_d += d[l] * even;
                    odd_d += d[l + 1] * odd;
                }
                const solver::Register near_c = load(&c1, part) * (even_c + odd_c),
                                       far_c = load(&c2, part) * (even_c - odd_c),
                                       near_d = load(&d1, part) * (even_d + odd_d),
                                       far_d = load(&d2, part) * (even_d - odd_d);
                even_c = near_c + far_c;
                odd_c = near_c - far_c;
                even_d = near_d + far_d;
                odd_d = near_d - far_d;
                for (int l = 0; l < orders; l += 2) {
                    store(load(out + l, part) + c[l] * even_c + d[l] * even_d, out + l, part);
                    store(load(out + l + 1, part) + c[l + 1] * odd_c + d[l + 1] * odd_d,
                          out + l + 1, part);
                }
            }
        }
    }

    int count_, stride_;  // azimuths; orders, even
    std::vector<double> phi_, cosine_;
};

class RoughHotSpot {
 public:
    RoughHotSpot(const solver::SolvedPaint& paint, const HotSpotTables& tables)
        : paint_(paint),
          tables_(tables),
          wavelengths_(static_cast<std::size_t>(paint.medium.wavelength_count())),
          nodes_(static_cast<int>(paint.multiple_scattering.exit_angle.size())),
          single_(paint.rough_single),
          multiple_(paint.multiple_scattering),
          azimuths_(std::max(paint.rough_single.orders(), paint.multiple_scattering.orders())) {
        const solver::PaintMedium& medium = paint.medium;
        for (int b = 0; b < paint::block_count(medium.wavelength_count()); ++b) {
            blocks_.emplace_back(paint, tables_, b);
        }
        const Quadrature polar = gauss_legendre(nodes_, 0, std::numbers::pi / 2);  // the exit nodes
        for (int a = 0; a < nodes_; ++a) {
            rays_.push_back(blocks_[0].ray(paint.multiple_scattering.exit_angle[a]));
            flux_.push_back(2 * std::numbers::pi * polar.weights[a] * std::sin(polar.nodes[a]) *
                            std::cos(polar.nodes[a]));
            for (const double ior : medium.ior) {
                entering_.push_back(
                    1 - solver::rough_interface(ior, medium.roughness)->albedo(polar.nodes[a]));
            }
        }
        set_ground();
    }

    solver::SolvedPaint run() {
        once_.assign(nodes_ * nodes_ * wavelengths_, 0.0);
        hot_spot_ = once_;
        parallel_for(0, nodes_, [&](int i) {
            for (int j = 0; j <= i; ++j) add_gain(i, j);
        });
        take_from_multiple();
        solver::SolvedPaint out = paint_;
        const NodeValues* const values[] = {&single_, &multiple_};
        solver::MultipleScattering* const tensors[] = {&out.rough_single, &out.multiple_scattering};
        parallel_for(
            0, 2, [&](int k) { *tensors[k] = values[k]->compressed(paint_.settings.tolerance); });
        return out;
    }

 private:
    template <class F>
    std::vector<double> at_all_wavelengths(F&& of_block) const {
        std::vector<double> out(wavelengths_);
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const FloatLanes values = of_block(blocks_[b]);
            const std::size_t first = b * kLanes, last = std::min(first + kLanes, wavelengths_);
            for (std::size_t w = first; w < last; ++w) out[w] = values[w - first];
        }
        return out;
    }
    std::size_t pair(int a, int b) const {
        return (static_cast<std::size_t>(a) * nodes_ + b) * wavelengths_;
    }

    void set_ground() {
        const solver::PaintMedium& medium = paint_.medium;
        const auto& reflectance = medium.substrate_reflectance;
        if (*std::max_element(reflectance.begin(), reflectance.end()) <= 0) return;
        ground_only_.emplace(paint_.multiple_scattering, false);
        for (int a = 0; a < nodes_; ++a) {
            const std::vector<double> through = at_all_wavelengths(
                [&](const HotSpotBlock& block) { return block.transmittance_of_layers(rays_[a]); });
            for (std::size_t w = 0; w < wavelengths_; ++w) {
                ground_.push_back(std::sqrt(std::numbers::inv_pi * reflectance[w]) *
                                  entering_[a * wavelengths_ + w] * through[w] / medium.ior[w]);
            }
        }
    }

    // Single scattering with the hot spot; the ground's own reflection, with it, taken out of
    // multiple scattering.
    void add_gain(int i, int j) {
        thread_local std::vector<FloatLanes> single_gain, ground_gain;  // [azimuth][block]
        single_gain.clear();
        ground_gain.clear();
        for (const double phi : azimuths_.phi()) {
            const Ray o = blocks_[0].ray(paint_.multiple_scattering.exit_angle[j], phi);
            for (const HotSpotBlock& block : blocks_) {
                const HotSpot::Pair pair = block.pair(rays_[i], o);
                single_gain.push_back(block.single_gain(rays_[i], o, phi, pair));
                if (ground_only_) ground_gain.push_back(pair.ground_gain());
            }
        }
        std::vector<double> once(wavelengths_), with_hot_spot(wavelengths_);
        const auto multiply = [&](NodeValues& values, const std::vector<FloatLanes>& gain) {
            const double* const order_0 = values.at(0, i, j);
            for (std::size_t w = 0; order_0 && w < wavelengths_; ++w) once[w] += order_0[w];
            azimuths_.multiply(values.rows(i, j), gain, wavelengths_);
            for (std::size_t w = 0; order_0 && w < wavelengths_; ++w)
                with_hot_spot[w] += order_0[w];
        };
        multiply(single_, single_gain);
        double* const multiple = multiple_.at(0, i, j);
        if (ground_only_ && multiple) {
            double* const ground = ground_only_->at(0, i, j);
            for (std::size_t w = 0; w < wavelengths_; ++w) {
                const double value = ground_[i * wavelengths_ + w] * ground_[j * wavelengths_ + w];
                ground[w] = std::clamp(multiple[w], 0.0, value);
                multiple[w] -= ground[w];
            }
            multiply(*ground_only_, ground_gain);
        }
        for (std::size_t w = 0; w < wavelengths_; ++w) {
            once_[pair(i, j) + w] = once_[pair(j, i) + w] = once[w];
            hot_spot_[pair(i, j) + w] = hot_spot_[pair(j, i) + w] = with_hot_spot[w] - once[w];
        }
    }

    void take_from_multiple() {
        const std::vector<double> scale = compensation();
        for (int i = 0; i < nodes_; ++i) {
            for (int j = 0; j <= i; ++j) {
                for (int l = 0; l < multiple_.orders(); ++l) {
                    double* const to = multiple_.at(l, i, j);
                    if (!to) continue;
                    const double* const ground = ground_only_ ? ground_only_->at(l, i, j) : nullptr;
                    for (std::size_t w = 0; w < wavelengths_; ++w) {
                        to[w] *= scale[i * wavelengths_ + w] * scale[j * wavelengths_ + w];
                        if (ground) to[w] += ground[w];
                    }
                }
            }
        }
    }

    // C by node and wavelength.
    std::vector<double> compensation() {
        const auto size = static_cast<std::size_t>(nodes_) * wavelengths_;
        std::vector<double> entered(size), lost(size), scale(size);
        parallel_for(0, nodes_, [&](int a) {
            const std::vector<double> scattered = at_all_wavelengths(
                [&](const HotSpotBlock& block) { return block.scattered_once(rays_[a]); });
            const std::vector<double> clear = at_all_wavelengths(
                [&](const HotSpotBlock& block) { return block.clear_transmittance(rays_[a]); });
            for (std::size_t w = 0; w < wavelengths_; ++w) {
                const std::size_t at = a * wavelengths_ + w;
                entered[at] = entering_[at] * scattered[w];
                // Of what leaves there, by what more of it the clearcoat has absorbed.
                const double c = std::max(clear[w], 1e-30), t = std::max(entering_[at], 1e-30);
                lost[at] = lost_at_interface(c, t) / (c * t);
            }
        });
        parallel_for(std::size_t{0}, wavelengths_, [&](std::size_t w) {
            std::vector<double> matrix(static_cast<std::size_t>(nodes_) * nodes_), sum(nodes_);
            for (int a = 0; a < nodes_; ++a) {
                double rescattered = entered[a * wavelengths_ + w], hot_spot = 0;
                for (int b = 0; b < nodes_; ++b) {
                    const double taken = flux_[b] * lost[b * wavelengths_ + w];
                    rescattered -= taken * once_[pair(a, b) + w];
                    hot_spot += taken * hot_spot_[pair(a, b) + w];
                    const double* const f = multiple_.at(0, a, b);
                    matrix[a * nodes_ + b] = f ? flux_[b] * std::max(0.0, f[w]) : 0.0;
                    sum[a] += matrix[a * nodes_ + b];
                }
                sum[a] *= std::max(0.0, 1 - hot_spot / std::max(rescattered, 1e-20));
            }
            const std::vector<double> g = balance(matrix, sum);
            for (int a = 0; a < nodes_; ++a) scale[a * wavelengths_ + w] = g[a];
        });
        return scale;
    }

    const solver::SolvedPaint& paint_;
    const HotSpotTables& tables_;
    std::size_t wavelengths_;
    int nodes_;
    NodeValues single_, multiple_;
    std::optional<NodeValues> ground_only_;  // what the ground alone has scattered
    Azimuths azimuths_;
    std::vector<HotSpotBlock> blocks_;
    std::vector<Ray> rays_;
    std::vector<double> flux_;               // of a node, of 1/sr
    std::vector<double> entering_, ground_;  // by node and wavelength
    std::vector<double> once_, hot_spot_;    // order 0, by pair of nodes and wavelength
};

}  // namespace

solver::SolvedPaint with_rough_hot_spot(const solver::SolvedPaint& paint) {
    return has_rough_interface(paint) ? RoughHotSpot(paint, HotSpotTables(paint)).run() : paint;
}

std::shared_ptr<const solver::SolvedPaint> with_rough_hot_spot(
    std::shared_ptr<const solver::SolvedPaint> paint, const HotSpotTables& tables) {
    if (!has_rough_interface(*paint)) return paint;
    return std::make_shared<const solver::SolvedPaint>(RoughHotSpot(*paint, tables).run());
}

}  // namespace nacre::bsdf
