#include "nacre/bsdf/models/hot_spot.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "nacre/bsdf/models/hot_spot_compensation.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/quadrature.h"
#include "nacre/paint/beckmann.h"
#include "nacre/paint/expansion.h"
#include "nacre/solver/directions.h"

namespace nacre::bsdf {
namespace {

// sqrt(sigma_b / mu), sigma_b = c Int (1 - T)^2 |w.m| D(m) dm, of `count` blocks of wavelengths from
// `first` on.
std::vector<DoubleLanes> coupling(const solver::FlakeMedium& flake, double mu, int first,
                                  int count) {
    std::vector<DoubleLanes> value(count);
    if (flake.table.is_opaque()) {
        std::fill(value.begin(), value.end(), splat(paint::projected_area(mu, flake.alpha)));
    } else {
        const paint::NormalWeights normals = flake.normals(mu);
        for (int b = 0; b < count; ++b) {
            value[b] = normals.sum_of_square(
                [&](int node) { return 1.0 - flake.table.transmittance_at(node, first + b); });
        }
    }
    for (DoubleLanes& of_block : value) {
        for (int i = 0; i < kLanes; ++i) {
            of_block[i] = std::sqrt(flake.area_density_per_um / mu * of_block[i]);
        }
    }
    return value;
}

}  // namespace

HotSpotTables::HotSpotTables(const solver::SolvedPaint& paint)
    : wavelength_count_(paint.medium.wavelength_count()),
      extinction_(extinction_by_direction(paint.medium)) {
    const solver::PaintMedium& medium = paint.medium;
    const paint::Recipe recipe = paint::expanded(paint.recipe);
    float top_um = 0;
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        top_um_.push_back(top_um);
        thickness_um_.push_back(static_cast<float>(medium.layers[l].thickness_um));
        top_um += thickness_um_.back();
        for (std::size_t f = 0; f < medium.layers[l].flakes.size(); ++f) {
            const solver::FlakeMedium& flake = medium.layers[l].flakes[f];
            Species& species = species_.emplace_back();
            species.layer = l;
            // Int O dz of a flake goes with area times d.
            species.diameter_um =
                static_cast<float>(recipe.layers[l].flakes[f].sizes().area_weighted_mean_um());
            species.coupling = tabulate_inside(medium, [&](double mu, int first, int count) {
                return coupling(flake, mu, first, count);
            });
        }
    }
    if (has_rough_interface(paint)) {
        coat_ = sparkle::CoatTilt(medium.roughness, mean_ior(medium));
        return;
    }
    if (species_.empty()) return;
    tabulate_ground(medium);
    compensation_ = compensation_factors(paint, *this);
    if (paint.recipe.flake_lean()) returned_ = internal_reflection_gains(paint, *this);
}

void HotSpotTables::tabulate_ground(const solver::PaintMedium& medium) {
    const auto& reflectance = medium.substrate_reflectance;
    if (*std::max_element(reflectance.begin(), reflectance.end()) <= 0) return;
    ground_.resize(static_cast<std::size_t>(kDirectionIntervals + 1) * wavelength_count_);
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        for (int w = 0; w < wavelength_count_; ++w) {
            const std::size_t at = static_cast<std::size_t>(row) * wavelength_count_ + w;
            double depth = medium.clearcoat_depth[w];
            for (std::size_t l = 0; l < medium.layers.size(); ++l) {
                depth += medium.layers[l].thickness_um * extinction_[l][at];
            }
            const double mu = solver::inside_cosine(medium.ior[w], direction_angle(row));
            ground_[at] = static_cast<float>(std::sqrt(std::numbers::inv_pi * reflectance[w]) *
                                             std::exp(-depth / mu));
        }
    }
}

double disc_overlap_integral(double x) {
    constexpr double kFullOverlap = 4 / (3 * std::numbers::pi);
    if (x >= 1) return kFullOverlap;
    const double chord2 = 1 - x * x, chord = std::sqrt(chord2);
    return 2 * std::numbers::inv_pi * (x * std::acos(x) - chord + chord * chord2 / 3 + 2.0 / 3);
}

namespace {

constexpr int kOverlapIntervals = 512;

std::span<const float> overlap_table() {
    static const std::vector<float> table = [] {
        std::vector<float> values;
        for (int n = 0; n <= kOverlapIntervals + 1; ++n) {
            values.push_back(
                static_cast<float>(disc_overlap_integral(n / double{kOverlapIntervals})));
        }
        return values;
    }();
    return table;
}

}  // namespace

template <class T>
inline T HotSpot::overlap(const T& x) const {
    const T at = min_lanes(x * kOverlapIntervals, T{} + kOverlapIntervals);
    const auto n = whole(at);
    const T before = gather(overlap_.data(), n);
    return before + (at - to_float(n)) * (gather(overlap_.data() + 1, n) - before);
}

HotSpot::HotSpot(const HotSpotTables& tables, const std::array<WavelengthPosition, kLanes>& where)
    : top_um_(tables.top_um_),
      thickness_um_(tables.thickness_um_),
      coat_(tables.coat_),
      overlap_(overlap_table()) {
    for (const HotSpotTables::Species& from : tables.species_) {
        Species& to = species_.emplace_back();
        to.layer = from.layer;
        to.diameter_um = from.diameter_um;
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            const float* values =
                from.coupling.data() + static_cast<std::size_t>(row) * tables.wavelength_count_;
            to.coupling.push_back(at_wavelengths(where, [&](int w) { return values[w]; }));
        }
    }
    const auto bind = [&](const std::vector<float>& from, std::vector<FloatLanes>& to) {
        for (std::size_t row = 0; row < from.size(); row += tables.wavelength_count_) {
            to.push_back(at_wavelengths(where, [&](int w) { return from[row + w]; }));
        }
    };
    bind(tables.ground_, ground_);
    bind(tables.compensation_, compensation_);
    bind(tables.returned_, returned_);
}

HotSpot::Pair::Pair(const HotSpot& hot_spot, const Ray& i, const Ray& o)
    : hot_spot_(&hot_spot), i_(&i), o_(&o) {
    const float x = i.inside.x / i.inside.z - o.inside.x / o.inside.z;
    const float y = i.inside.y / i.inside.z - o.inside.y / o.inside.z;
    const float distance = hot_spot.coat_.separation(x * x + y * y, i.inside.z, o.inside.z);
    // Beyond the upper bound, at grazing incidence without a coat, the integrals below are nil; at
    // the lower one they are those of rays that coincide.
    spread_ = std::clamp(distance, 1e-4f, 1e6f);
}

template <class Add>
void HotSpot::Pair::for_each_species(std::size_t layer, Add&& add) const {
    const HotSpot& h = *hot_spot_;
    for (const Species& s : h.species_) {
        if (s.layer > layer) break;
        // Heights between which the species lies, from the flake upwards, in um.
        const float over_top = h.top_um_[layer] - h.top_um_[s.layer];
        const float within = s.layer == layer ? 0.0f : h.thickness_um_[s.layer];
        const float step = spread_ / s.diameter_um;
        add(i_->look_up(s.coupling) * o_->look_up(s.coupling), [=, &h](const auto& u) {
            const auto far = u * h.thickness_um_[layer] + over_top;
            const auto shared = h.overlap(far * step);
            if (!(within > 0)) return shared / step;
            return (shared - h.overlap((far - within) * step)) / step;
        });
    }
}

FloatLanes HotSpot::Pair::gain(std::size_t layer, float u) const {
    FloatLanes sum{};
    for_each_species(layer, [&](const FloatLanes& coupling, auto&& length_um) {
        sum += coupling * length_um(u);
    });
    return sum;
}

void HotSpot::Pair::add_gains(std::size_t layer, const FloatLanes& u,
                              std::array<FloatLanes, kLanes>& sums) const {
    for_each_species(layer, [&](const FloatLanes& coupling, auto&& length_um) {
        const FloatLanes shared_um = length_um(u);
        for (int lane = 0; lane < kLanes; ++lane) sums[lane] += coupling * shared_um[lane];
    });
}

FloatLanes HotSpot::Pair::mean(std::size_t layer, const FloatLanes& depth) const {
    if (layer == mean_layer_ && std::memcmp(&depth, &mean_depth_, sizeof depth) == 0) return mean_;
    // What comes from below 18 optical depths, 9 with all of the gain, is 1e-4 of the whole.
    constexpr float kDeep = 18;
    constexpr int kMaxNodes = 10;
    const FloatLanes safe = max_lanes(depth, splat(1e-20f));
    const float reach = std::min(1.0f, kDeep / -lane_max(-safe));
    const float deepest = reach * lane_max(safe);
    static const Quadrature &few = unit_gauss_legendre(5), &some = unit_gauss_legendre(8),
                            &many = unit_gauss_legendre(kMaxNodes);
    const Quadrature& rule = deepest < 2 ? few : deepest < 8 ? some : many;
    const std::size_t count = rule.nodes.size();
    std::array<float, kMaxNodes + kLanes> fraction{};
    std::array<FloatLanes, kMaxNodes> exponent;
    for (std::size_t n = 0; n < count; ++n) {
        // In the root of the depth, as most comes from near the top.
        fraction[n] = reach * static_cast<float>(rule.nodes[n] * rule.nodes[n]);
        exponent[n] = -safe * fraction[n];
    }
    for_each_species(layer, [&](const FloatLanes& coupling, auto&& length_um) {
        for (std::size_t first = 0; first < count; first += kLanes) {
            const FloatLanes shared_um = length_um(load_lanes(&fraction[first]));
            for (std::size_t n = first; n < std::min(count, first + kLanes); ++n)
                exponent[n] += coupling * shared_um[n - first];
        }
    });
    FloatLanes sum{};
    for (std::size_t n = 0; n < count; ++n) {
        sum += static_cast<float>(2 * rule.nodes[n] * rule.weights[n]) *
               exp_lanes(min_lanes(exponent[n], splat(kMaxGain)));
    }
    mean_layer_ = layer;
    mean_depth_ = depth;
    mean_ = sum * reach * safe / one_minus_exp_lanes(safe);
    return mean_;
}

FloatLanes HotSpot::Pair::ground() const {
    const std::vector<FloatLanes>& table = hot_spot_->ground_;
    return table.empty() ? FloatLanes{} : i_->look_up(table) * o_->look_up(table);
}

FloatLanes HotSpot::Pair::ground_gain() const {
    return exp_lanes(min_lanes(gain(hot_spot_->thickness_um_.size() - 1, 1), splat(kMaxGain)));
}

FloatLanes HotSpot::Pair::compensation() const {
    const std::vector<FloatLanes>& by_direction = hot_spot_->compensation_;
    if (by_direction.empty()) return splat(1.0f);
    return i_->look_up(by_direction) * o_->look_up(by_direction);
}

FloatLanes HotSpot::Pair::internal_reflection_gain() const {
    const std::vector<FloatLanes>& by_direction = hot_spot_->returned_;
    if (by_direction.empty()) return splat(1.0f);
    return i_->look_up(by_direction) * o_->look_up(by_direction);
}

FloatLanes HotSpot::Pair::multiple(const FloatLanes& transfer,
                                   const FloatLanes& compensation) const {
    const HotSpot& h = *hot_spot_;
    if (h.compensation_.empty()) return transfer;
    if (h.ground_.empty()) return compensation * transfer;
    const FloatLanes once = ground();
    return compensation * max_lanes(transfer - once, FloatLanes{}) + ground_gain() * once;
}

}  // namespace nacre::bsdf
