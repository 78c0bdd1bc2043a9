#include "nacre/bsdf/tabulated/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/paint_interface.h"
#include "nacre/bsdf/tabulated/table_pairs.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/directions.h"
#include "nacre/solver/lane_registers.h"
#include "nacre/spectra/rgb.h"

namespace nacre::bsdf {

void validate(const BrdfGrid& grid) {
    require_in_range(grid.angles, 8, BrdfGrid::kMaxAngles, "angles of a BRDF table");
    require_in_range(grid.azimuths, 8, BrdfGrid::kMaxAzimuths, "azimuths of a BRDF table");
    require_in_range(grid.ior, 1, 3, "ior of a BRDF table");
    require_in_range(grid.roughness, 0, 1, "roughness of a BRDF table");
    require_in_range(grid.lobe_alpha, 1e-4, 1, "lobe_alpha of a BRDF table");
}

double BrdfGrid::angle(int node) const {
    const double x = static_cast<double>(node) / (angles - 1);
    return std::min(2 * std::atan(x), std::numbers::pi / 2 - 1e-4);
}

double BrdfGrid::azimuth(double theta_i, double theta_o, int node) const {
    const double u2 = std::pow(static_cast<double>(node) / (azimuths - 1), 2);
    const double side = side_ior();
    const double scale =
        side * lobe_alpha *
        (solver::inside_cosine(side, theta_i) + solver::inside_cosine(side, theta_o));
    const double ratio = 4 * std::sin(theta_i) * std::sin(theta_o) / (scale * scale);
    const double v2 = ratio > 1e-4 ? std::expm1(u2 * std::log1p(ratio)) / ratio : u2;
    return std::numbers::pi - 2 * std::asin(std::sqrt(std::min(v2, 1.0)));
}

double BrdfGrid::factor(double theta_i, double theta_o) const {
    const double side = side_ior();
    const double mu = solver::inside_cosine(side, theta_i) + solver::inside_cosine(side, theta_o);
    if (roughness > 0) return 1 / mu;
    const double t_i = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_i));
    const double t_o = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_o));
    return t_i * t_o / (ior * ior * mu);
}

BrdfTableRows::BrdfTableRows(const solver::SolvedPaint& paint, const BrdfGrid& grid)
    : paint_(paint), grid_(grid), tensors_{&paint.multiple_scattering} {
    if (grid.roughness > 0) tensors_.push_back(&paint.rough_single);
    const std::vector<Vec3d> weights = spectra::rec709_weights(paint.wavelengths_nm());
    for (const solver::WavelengthGroup& group : group_wavelengths(paint.medium)) {
        groups_.push_back(make_group(group, weights));
    }
}

BrdfTableRows::Group BrdfTableRows::make_group(const solver::WavelengthGroup& wavelengths,
                                               const std::vector<Vec3d>& weights) const {
    Group group;
    group.ior = paint_.medium.ior[wavelengths.members[0]];
    group.medium = select_wavelengths(paint_.medium, wavelengths.distinct);
    const int blocks = paint::block_count(static_cast<int>(wavelengths.distinct.size()));
    group.weights.resize(blocks);
    for (std::size_t k = 0; k < wavelengths.members.size(); ++k) {
        const int d = wavelengths.solved_as[k];
        for (int c = 0; c < 3; ++c) {
            const double weight = weights[wavelengths.members[k]][c];
            group.weights[d / kLanes][c][d % kLanes] += weight;
            group.white[c] += weight;
        }
    }
    for (const solver::MultipleScattering* tensor : tensors_) {
        auto& basis = group.basis.emplace_back(tensor->rank(), Vec3d{});
        for (int k = 0; k < tensor->rank(); ++k) {
            for (int w : wavelengths.members) {
                for (int c = 0; c < 3; ++c) {
                    basis[k][c] += weights[w][c] * tensor->basis[k * tensor->wavelength_count + w];
                }
            }
        }
    }
    if (grid_.roughness > 0) {
        group.interface = solver::rough_interface(group.ior, grid_.roughness);
        for (int i = 0; i < grid_.angles; ++i) {
            group.masked.push_back(group.interface->masked(grid_.angle(i)));
        }
        return group;
    }
    for (const solver::LayerMedium& layer : group.medium.layers) {
        auto& extinction = group.extinction.emplace_back();
        for (int i = 0; i < grid_.angles; ++i) {
            const double mu = solver::inside_cosine(group.ior, grid_.angle(i));
            for (int block = 0; block < blocks; ++block) {
                extinction.push_back(solver::extinction(layer, mu, block));
            }
        }
    }
    return group;
}

BrdfTableRows::Workspace BrdfTableRows::make_workspace(int i) const {
    Workspace work{i, grid_.angle(i), {}, std::vector<double>(grid_.azimuths), {}, {}, {}};
    std::size_t orders = 0, terms = 0;
    for (const solver::MultipleScattering* tensor : tensors_) {
        work.slices.emplace_back(*tensor, work.theta_i);
        orders = std::max(orders, tensor->first.size());
        terms = std::max(terms, tensor->first.size() * tensor->rank());
    }
    work.term.resize(terms);
    work.by_order.resize(orders);
    work.rgb.resize(grid_.azimuths);
    return work;
}

// g / f times the Fresnel factors of the group's own index, which the tensors and single scattering
// do not contain, and which differ from those of the mean index if the binder is dispersive.
double BrdfTableRows::scale(const Group& group, double theta_i, double theta_o) const {
    const double all = 1 / grid_.factor(theta_i, theta_o);
    if (grid_.roughness > 0) return all;
    const double t_i = 1 - optics::dielectric_reflectance(1.0, group.ior, std::cos(theta_i));
    const double t_o = 1 - optics::dielectric_reflectance(1.0, group.ior, std::cos(theta_o));
    return all * t_i * t_o / (group.ior * group.ior);
}

void BrdfTableRows::evaluate(Workspace& work, int o, float* out) const {
    const double theta_o = grid_.angle(o);
    for (int j = 0; j < grid_.azimuths; ++j) {
        work.azimuth[j] = grid_.azimuth(work.theta_i, theta_o, j);
    }
    evaluate_at_azimuths(work, o, out);
}

void BrdfTableRows::evaluate_at_azimuths(Workspace& work, int o, float* out) const {
    const double theta_o = grid_.angle(o);
    std::fill(work.rgb.begin(), work.rgb.end(), Vec3d{});
    add_tensors(work, theta_o);
    for (const Group& group : groups_) {
        const double s = scale(group, work.theta_i, theta_o);
        if (grid_.roughness > 0) {
            add_interface(group, s, work, o);
        } else {
            add_single(group, s, work, o);
        }
    }
    for (int j = 0; j < grid_.azimuths; ++j) {
        for (int c = 0; c < 3; ++c) out[3 * j + c] = static_cast<float>(work.rgb[j][c]);
    }
}

// Sum over azimuthal orders by Clenshaw's recurrence.           [clenshaw-1955]
void BrdfTableRows::add_tensors(Workspace& work, double theta_o) const {
    for (std::size_t t = 0; t < tensors_.size(); ++t) {
        const solver::MultipleScattering& tensor = *tensors_[t];
        const int orders = tensor.orders(), rank = tensor.rank();
        work.slices[t].by_order({&theta_o, 1}, work.term);
        std::vector<Vec3d> basis(rank, Vec3d{});
        for (const Group& group : groups_) {
            const double s = scale(group, work.theta_i, theta_o);
            for (int k = 0; k < rank; ++k) {
                for (int c = 0; c < 3; ++c) basis[k][c] += s * group.basis[t][k][c];
            }
        }
        for (int l = 0; l < orders; ++l) {
            Vec3d sum{};
            for (int k = 0; k < rank; ++k) {
                for (int c = 0; c < 3; ++c) sum[c] += work.term[l * rank + k] * basis[k][c];
            }
            work.by_order[l] = (l ? 2.0 : 1.0) * sum;
        }
        if (orders == 0) continue;
        // As many azimuths at once as a register holds; the last one again where there are no more.
        using solver::Register, solver::kRegisterLanes;
        for (int first = 0; first < grid_.azimuths; first += kRegisterLanes) {
            const int count = std::min(kRegisterLanes, grid_.azimuths - first);
            // cos(l (phi - pi)) = (-1)^l cos(l phi): the recurrence in -cos phi.
            Register cosine;
            for (int lane = 0; lane < kRegisterLanes; ++lane) {
                cosine[lane] = -std::cos(work.azimuth[first + std::min(lane, count - 1)]);
            }
            const Register twice = 2 * cosine;
            Register next[3] = {}, after[3] = {};
            for (int l = orders - 1; l > 0; --l) {
                for (int c = 0; c < 3; ++c) {
                    const Register here = work.by_order[l][c] + twice * next[c] - after[c];
                    after[c] = next[c];
                    next[c] = here;
                }
            }
            for (int c = 0; c < 3; ++c) {
                const Register sum = work.by_order[0][c] + cosine * next[c] - after[c];
                for (int lane = 0; lane < count; ++lane) work.rgb[first + lane][c] += sum[lane];
            }
        }
    }
}

// The closed form of solver::single_scattering, with the integral over depth once per pair of polar
// nodes.
void BrdfTableRows::add_single(const Group& group, double scale, Workspace& work, int o) const {
    const double mu_i = solver::inside_cosine(group.ior, work.theta_i);
    const double mu_o = solver::inside_cosine(group.ior, grid_.angle(o));
    const int blocks = static_cast<int>(group.weights.size());
    for (int block = 0; block < blocks; ++block) {
        DoubleLanes depth =
            solver::block_lanes(group.medium.clearcoat_depth, block) * (1 / mu_i + 1 / mu_o);
        for (std::size_t n = 0; n < group.medium.layers.size(); ++n) {
            const solver::LayerMedium& layer = group.medium.layers[n];
            const DoubleLanes here =
                layer.thickness_um * (group.extinction[n][work.i * blocks + block] / mu_i +
                                      group.extinction[n][o * blocks + block] / mu_o);
            const DoubleLanes reach = make_lanes<DoubleLanes>([&](int lane) {
                const double x = here[lane];
                return std::exp(-depth[lane]) * mean_attenuation(x);
            });
            const DoubleLanes factor = scale * layer.thickness_um / (mu_i * mu_o) * reach;
            std::array<DoubleLanes, 3> weight;
            for (int c = 0; c < 3; ++c) weight[c] = group.weights[block][c] * factor;
            for (int j = 0; j < grid_.azimuths; ++j) {
                const DoubleLanes kernel =
                    backscattering(layer, mu_i, mu_o, work.azimuth[j], block);
                for (int c = 0; c < 3; ++c) work.rgb[j][c] += lane_sum(kernel * weight[c]);
            }
            depth += here;
        }
    }
}

void BrdfTableRows::add_interface(const Group& group, double scale, Workspace& work, int o) const {
    const double masked = group.interface->diffuse_scale() * group.masked[work.i] * group.masked[o];
    for (int j = 0; j < grid_.azimuths; ++j) {
        const double f =
            masked + group.interface->facet_brdf(work.theta_i, grid_.angle(o), work.azimuth[j]);
        for (int c = 0; c < 3; ++c) work.rgb[j][c] += scale * group.white[c] * f;
    }
}

namespace {

// Roughness of the narrowest lobe on the side on which the grid measures half vectors.
double narrowest_lobe(const solver::PaintMedium& medium, double ior) {
    double alpha = 1;
    for (const solver::LayerMedium& layer : medium.layers) {
        for (const solver::FlakeMedium& flake : layer.flakes) alpha = std::min(alpha, flake.alpha);
    }
    if (medium.roughness > 0) alpha = std::min(ior * alpha, medium.roughness);
    return alpha;
}

}  // namespace

BrdfGrid make_grid(const solver::SolvedPaint& paint, const BrdfTableSettings& settings) {
    const solver::PaintMedium& medium = paint.medium;
    BrdfGrid grid;
    grid.angles = settings.angles;
    grid.azimuths = settings.azimuths;
    grid.ior = mean_index(medium);
    grid.roughness = has_rough_interface(paint, "tabulated") ? medium.roughness : 0.0;
    grid.lobe_alpha = narrowest_lobe(medium, grid.ior);
    validate(grid);
    return grid;
}

RawBrdfTable make_raw_table(const solver::SolvedPaint& paint, const BrdfTableSettings& settings,
                            const Progress& progress) {
    RawBrdfTable table;
    table.paint = paint.recipe.name;
    table.grid = make_grid(paint, settings);
    const BrdfTableRows rows(paint, table.grid);
    set_pairs(table, "the BRDF table", progress, [&](int i) {
        return [&rows, work = rows.make_workspace(i)](int o, float* out) mutable {
            rows.evaluate(work, o, out);
        };
    });
    return table;
}

}  // namespace nacre::bsdf
