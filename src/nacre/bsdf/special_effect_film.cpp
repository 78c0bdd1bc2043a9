#include "nacre/bsdf/special_effect_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"

namespace nacre::bsdf {

SpreadFilm::SpreadFilm(const optics::AiryFilm& film, double film_ior, optics::ThicknessRange range,
                       const Wavelengths& wavelengths_nm)
    : film_(film),
      lo_nm_(static_cast<float>(range.lo_nm)),
      width_nm_(static_cast<float>(range.hi_nm - range.lo_nm)),
      inverse_wavelengths_(
          make_lanes([&](int i) { return static_cast<float>(1 / wavelengths_nm[i]); })) {
    if (!(range.hi_nm > range.lo_nm)) {
        nodes_.push_back({lo_nm_ * inverse_wavelengths_, 1});
        return;
    }
    // Half the range of the phase 4 pi n d / lambda. The rule needs about as many nodes, and more
    // for the overtones of a strong film.
    const double shortest = *std::min_element(wavelengths_nm.begin(), wavelengths_nm.end());
    const double phase = 2 * std::numbers::pi * film_ior * (range.hi_nm - range.lo_nm) / shortest;
    constexpr double kMostNodes = 100000;
    const int count = static_cast<int>(std::min(kMostNodes, std::ceil(4 + 2 * phase)));
    const Quadrature rule = gauss_legendre(count, range.lo_nm, range.hi_nm);
    for (int i = 0; i < count; ++i) {
        nodes_.push_back({static_cast<float>(rule.nodes[i]) * inverse_wavelengths_,
                          static_cast<float>(rule.weights[i] / (range.hi_nm - range.lo_nm))});
    }
}

FloatLanes SpreadFilm::mean(const optics::AiryAngle<float>& angle) const {
    FloatLanes sum{};
    for (const Node& node : nodes_) {
        sum += node.weight * angle.reflectance(node.thickness_over_wavelength);
    }
    return sum;
}

FloatLanes SpreadFilm::sum(float cosine, const sparkle::FacetTally& facets) const {
    const optics::AiryAngle<float> angle = film_.at(cosine);
    if (width_nm_ == 0) return static_cast<float>(facets.count) * mean(angle);
    FloatLanes sum{};
    for (int i = 0; i < facets.listed; ++i) {
        const float thickness_nm = lo_nm_ + width_nm_ * facets.thickness[i];
        sum += angle.reflectance(thickness_nm * inverse_wavelengths_);
    }
    if (facets.count == static_cast<std::uint64_t>(facets.listed)) return sum;
    const float listed = static_cast<float>(facets.listed);
    const float count = static_cast<float>(facets.count);
    const FloatLanes expected = mean(angle);
    return count * (expected + std::sqrt(listed / count) * (sum * (1 / listed) - expected));
}

}  // namespace nacre::bsdf
