#include "nacre/io/panel_image.h"

#include <cmath>

#include "nacre/spectra/rgb.h"

namespace nacre::io {

Image image_of(const measure::PanelPicture& picture, std::map<std::string, std::string> metadata) {
    Image image{
        picture.width, picture.height, {{"R", {}}, {"G", {}}, {"B", {}}}, std::move(metadata)};
    for (Channel& channel : image.channels) channel.pixels.reserve(picture.pixel_count());
    for (std::size_t p = 0; p < picture.pixel_count(); ++p) {
        const float* const xyz = &picture.xyz[3 * p];
        const Vec3d rgb = spectra::xyz_to_linear_rec709({xyz[0], xyz[1], xyz[2]});
        for (std::size_t c = 0; c < 3; ++c) {
            image.channels[c].pixels.push_back(static_cast<float>(rgb[c]));
        }
    }
    return image;
}

double display_stops(const measure::PanelPicture& picture) {
    constexpr double kShown = 0.25;
    const double mean = measure::mean_luminance(picture);
    return mean > 0 ? std::log2(kShown / mean) : 0;
}

}  // namespace nacre::io
