#include "nacre/bsdf/models/hot_spot_brdf.h"

#include <cmath>

#include "nacre/bsdf/models/rough_hot_spot.h"

namespace nacre::bsdf {

HotSpotBrdf::HotSpotBrdf(const solver::SolvedPaint& paint)
    : paint_(paint), inverse_mean_ior_(1 / mean_ior(paint.medium)) {
    if (has_rough_interface(paint)) {
        rough_ = with_rough_hot_spot(paint);
        return;
    }
    const HotSpotTables tables(paint_);
    const int count = paint_.medium.wavelength_count();
    for (int block = 0; block < paint::block_count(count); ++block) {
        blocks_.emplace_back(tables, wavelengths_of_block(count, block));
    }
}

std::vector<double> HotSpotBrdf::operator()(double theta_i, double theta_o, double phi,
                                            Part part) const {
    if (rough_) return rough_->brdf(theta_i, theta_o, phi, part);
    const Ray i = make_ray(theta_i, 0, inverse_mean_ior_),
              o = make_ray(theta_o, phi, inverse_mean_ior_);
    std::vector<double> f(paint_.medium.wavelength_count(), 0.0);
    if (part != Part::single) {
        f = paint_.brdf(theta_i, theta_o, phi, Part::multiple);
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            const HotSpot::Pair pair(blocks_[block], i, o);
            FloatLanes bare{};
            std::array<double, kLanes> factor;
            const std::size_t first = block * kLanes, last = std::min(first + kLanes, f.size());
            for (std::size_t w = first; w < last; ++w) {
                factor[w - first] =
                    solver::interface_factor(paint_.medium.ior[w], theta_i, theta_o);
                bare[w - first] = static_cast<float>(f[w] / factor[w - first]);
            }
            const FloatLanes changed = pair.multiple(bare);
            for (std::size_t w = first; w < last; ++w) {
                f[w] = factor[w - first] * changed[w - first];
            }
        }
    }
    if (part != Part::multiple) {
        const std::vector<double> single = solver::single_scattering(
            paint_.medium, theta_i, theta_o, phi,
            [&](std::size_t layer, int block, const DoubleLanes& depth) {
                return to_double(HotSpot::Pair(blocks_[block], i, o).mean(layer, to_float(depth)));
            });
        for (std::size_t w = 0; w < f.size(); ++w) f[w] += single[w];
    }
    return f;
}

}  // namespace nacre::bsdf
