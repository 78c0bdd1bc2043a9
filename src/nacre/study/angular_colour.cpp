#include "nacre/study/angular_colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/report/plot.h"
#include "nacre/spectra/colour.h"

namespace nacre::study {

std::vector<AngularColour> angular_colours(const models::SpectralBrdf& surface,
                                           const std::vector<double>& aspecular_deg) {
    constexpr double kDegree = std::numbers::pi / 180, kIncidence_deg = 45;
    const std::vector<double>& nm = surface.wavelengths_nm();
    const spectra::Vec3 white =
        spectra::white_point(nm, spectra::Illuminant::D65, spectra::Observer::cie1931_2deg);
    std::vector<AngularColour> colours;
    for (double aspecular : aspecular_deg) {
        const double view_deg = kIncidence_deg - aspecular;  // positive on the mirror side
        std::vector<double> reflectance =
            surface(kIncidence_deg * kDegree, std::abs(view_deg) * kDegree,
                    view_deg >= 0 ? std::numbers::pi : 0);
        for (double& r : reflectance) r *= std::numbers::pi;
        const spectra::Vec3 xyz = spectra::reflectance_to_xyz(
            nm, reflectance, spectra::Illuminant::D65, spectra::Observer::cie1931_2deg);
        spectra::Vec3 rgb =
            spectra::xyz_to_linear_rec709({xyz[0] / 100, xyz[1] / 100, xyz[2] / 100});
        // A lobe is far brighter than white: its chip shows the hue at full light.
        const double peak = std::max({rgb[0], rgb[1], rgb[2], 1.0});
        for (double& c : rgb) c = spectra::srgb_encode(std::clamp(c / peak, 0.0, 1.0));
        colours.push_back({aspecular, spectra::xyz_to_lab(xyz, white), report::css_colour(rgb)});
    }
    return colours;
}

}  // namespace nacre::study
