#include "nacre/io/image.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/image_formats.h"

namespace nacre::io {

const Channel* Image::find(std::string_view name) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& c) { return c.name == name; });
    return found == channels.end() ? nullptr : &*found;
}

void check_image_size(const std::string& name, long width, long height, std::size_t channels,
                      std::size_t most_values) {
    if (width < 1 || height < 1 || width > kMostPixelsPerSide || height > kMostPixelsPerSide) {
        throw InputError(fmt::format("{}: size = {} x {}: each side must be in [1, {}] pixels",
                                     name, width, height, kMostPixelsPerSide));
    }
    if (channels < 1 || channels > kMostChannels) {
        throw InputError(
            fmt::format("{}: has {} channels; must be in [1, {}]", name, channels, kMostChannels));
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels * channels > most_values) {
        throw InputError(fmt::format("{}: {} x {} pixels of {} channels: more than {} values", name,
                                     width, height, channels, most_values));
    }
}

Image blank_image(const std::string& name, long width, long height,
                  const std::vector<std::string>& channels, std::size_t most_values) {
    check_image_size(name, width, height, channels.size(), most_values);
    Image image{static_cast<int>(width), static_cast<int>(height), {}, {}};
    for (const std::string& channel : channels) {
        image.channels.push_back({channel, std::vector<float>(image.pixel_count())});
    }
    return image;
}

bool looks_like_image(std::string_view bytes) {
    return looks_like_exr(bytes) || looks_like_png(bytes) || looks_like_radiance_hdr(bytes);
}

Image parse_image(std::string_view bytes, const std::string& name, std::size_t most_values) {
    if (looks_like_exr(bytes)) return parse_exr(bytes, name, most_values);
    if (looks_like_png(bytes)) return parse_png(bytes, name, most_values);
    if (looks_like_radiance_hdr(bytes)) return parse_radiance_hdr(bytes, name, most_values);
    throw InputError(
        fmt::format("{}: is not a picture; OpenEXR, Radiance HDR and PNG can be read", name));
}

Image read_image(const std::filesystem::path& path, std::size_t most_values) {
    return parse_image(read_file(path, kMostImageFileBytes), path.string(), most_values);
}

std::vector<float> interleaved_rgb(const Image& image, const std::string& name) {
    const Channel* gray = image.find("Y");
    const Channel* rgb[3] = {image.find("R"), image.find("G"), image.find("B")};
    for (const Channel*& channel : rgb) {
        if (!channel) channel = gray;
        if (!channel) throw InputError(fmt::format("{}: has no channels R, G and B", name));
    }
    std::vector<float> interleaved(3 * image.pixel_count());
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) interleaved[3 * i + c] = rgb[c]->pixels[i];
    }
    return interleaved;
}

std::string spectral_channel_name(double wavelength_nm) {
    std::string number = fmt::format("{:.6f}", wavelength_nm);
    std::replace(number.begin(), number.end(), '.', ',');
    return fmt::format("S0.{}nm", number);
}

}  // namespace nacre::io
