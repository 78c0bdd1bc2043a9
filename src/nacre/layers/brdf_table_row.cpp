#include "nacre/layers/brdf_table_row.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/layers/directions.h"
#include "nacre/optics/dielectric.h"
#include "nacre/spectra/rgb_basis.h"

namespace nacre::layers {

using spectra::Vec3;

BrdfTableRows::BrdfTableRows(const SolvedPaint& paint, const BrdfGrid& grid)
    : paint_(paint), grid_(grid), tensors_{&paint.remainder} {
    if (grid.roughness > 0) tensors_.push_back(&paint.rough_single);
    const std::vector<Vec3> weights = spectra::rec709_weights(paint.wavelengths_nm());
    for (const WavelengthGroup& group : group_wavelengths(paint.medium)) {
        groups_.push_back(make_group(group, weights));
    }
}

BrdfTableRows::Group BrdfTableRows::make_group(const WavelengthGroup& wavelengths,
                                               const std::vector<Vec3>& weights) const {
    Group group;
    group.ior = paint_.medium.ior[wavelengths.members[0]];
    group.medium = select_wavelengths(paint_.medium, wavelengths.distinct);
    const int blocks = flakes::block_count(static_cast<int>(wavelengths.distinct.size()));
    group.weights.resize(blocks);
    for (std::size_t k = 0; k < wavelengths.members.size(); ++k) {
        const int d = wavelengths.solved_as[k];
        for (int c = 0; c < 3; ++c) {
            const double weight = weights[wavelengths.members[k]][c];
            group.weights[d / kLanes][c][d % kLanes] += weight;
            group.white[c] += weight;
        }
    }
    for (const Remainder* tensor : tensors_) {
        auto& basis = group.basis.emplace_back(tensor->rank(), Vec3{});
        for (int k = 0; k < tensor->rank(); ++k) {
            for (int w : wavelengths.members) {
                for (int c = 0; c < 3; ++c) {
                    basis[k][c] += weights[w][c] * tensor->basis[k * tensor->wavelength_count + w];
                }
            }
        }
    }
    if (grid_.roughness > 0) {
        group.interface = rough_interface(group.ior, grid_.roughness);
        for (int i = 0; i < grid_.angles; ++i) {
            group.masked.push_back(group.interface->masked(grid_.angle(i)));
        }
        return group;
    }
    for (const LayerMedium& layer : group.medium.layers) {
        auto& extinction = group.extinction.emplace_back();
        for (int i = 0; i < grid_.angles; ++i) {
            const double mu = inside_cosine(group.ior, grid_.angle(i));
            for (int block = 0; block < blocks; ++block) {
                extinction.push_back(layers::extinction(layer, mu, block));
            }
        }
    }
    return group;
}

BrdfTableRows::Workspace BrdfTableRows::make_workspace(int i) const {
    Workspace work{i, grid_.angle(i), {}, std::vector<double>(grid_.azimuths), {}, {}, {}};
    std::size_t orders = 0, terms = 0;
    for (const Remainder* tensor : tensors_) {
        work.slices.emplace_back(*tensor, work.theta_i);
        orders = std::max(orders, tensor->first.size());
        terms = std::max(terms, tensor->first.size() * tensor->rank());
    }
    work.term.resize(terms);
    work.by_order.resize(orders);
    work.rgb.resize(grid_.azimuths);
    return work;
}

// g / f times what the tensors and the single scattering of the group leave out: its own Fresnel
// factors, which differ from those of the mean index if the binder is dispersive.
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
    std::fill(work.rgb.begin(), work.rgb.end(), Vec3{});
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
        const Remainder& tensor = *tensors_[t];
        const int orders = tensor.orders(), rank = tensor.rank();
        work.slices[t].by_order(theta_o, work.term);
        std::vector<Vec3> basis(rank, Vec3{});
        for (const Group& group : groups_) {
            const double s = scale(group, work.theta_i, theta_o);
            for (int k = 0; k < rank; ++k) {
                for (int c = 0; c < 3; ++c) basis[k][c] += s * group.basis[t][k][c];
            }
        }
        for (int l = 0; l < orders; ++l) {
            Vec3 sum{};
            for (int k = 0; k < rank; ++k) {
                for (int c = 0; c < 3; ++c) sum[c] += work.term[k * orders + l] * basis[k][c];
            }
            for (double& x : sum) x *= l ? 2 : 1;
            work.by_order[l] = sum;
        }
        for (int j = 0; j < grid_.azimuths; ++j) {
            // cos(l (phi - pi)) = (-1)^l cos(l phi): the recurrence in -cos phi.
            const double cosine = -std::cos(work.azimuth[j]);
            Vec3 next{}, after{};
            for (int l = orders - 1; l > 0; --l) {
                for (int c = 0; c < 3; ++c) {
                    const double here = work.by_order[l][c] + 2 * cosine * next[c] - after[c];
                    after[c] = next[c];
                    next[c] = here;
                }
            }
            for (int c = 0; orders > 0 && c < 3; ++c) {
                work.rgb[j][c] += work.by_order[0][c] + cosine * next[c] - after[c];
            }
        }
    }
}

// The closed form of layers::single_scattering, the depth integral once a pair of nodes.
void BrdfTableRows::add_single(const Group& group, double scale, Workspace& work, int o) const {
    const double mu_i = inside_cosine(group.ior, work.theta_i);
    const double mu_o = inside_cosine(group.ior, grid_.angle(o));
    const int blocks = static_cast<int>(group.weights.size());
    for (int block = 0; block < blocks; ++block) {
        DoubleLanes depth =
            block_lanes(group.medium.clearcoat_depth, block) * (1 / mu_i + 1 / mu_o);
        for (std::size_t n = 0; n < group.medium.layers.size(); ++n) {
            const LayerMedium& layer = group.medium.layers[n];
            const DoubleLanes here =
                layer.thickness_um * (group.extinction[n][work.i * blocks + block] / mu_i +
                                      group.extinction[n][o * blocks + block] / mu_o);
            const DoubleLanes reach = make_lanes<DoubleLanes>([&](int lane) {
                const double x = here[lane];
                return std::exp(-depth[lane]) * (x > 1e-12 ? -std::expm1(-x) / x : 1.0);
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

}  // namespace nacre::layers
