#include "nacre/io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/core/version.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

const Channel* Image::find(std::string_view name) const {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& c) { return c.name == name; });
    return found == channels.end() ? nullptr : &*found;
}

void check_image_size(const std::string& name, long width, long height, std::size_t channels,
                      std::size_t max_values) {
    if (width < 1 || height < 1 || width > kMaxPixelsPerSide || height > kMaxPixelsPerSide) {
        throw InputError(fmt::format("{}: size = {} x {}: each side must be in [1, {}] pixels",
                                     name, width, height, kMaxPixelsPerSide));
    }
    if (channels < 1 || channels > kMaxChannels) {
        throw InputError(
            fmt::format("{}: has {} channels; must be in [1, {}]", name, channels, kMaxChannels));
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels * channels > max_values) {
        throw InputError(fmt::format("{}: {} x {} pixels of {} channels: more than {} values", name,
                                     width, height, channels, max_values));
    }
}

Image blank_image(const std::string& name, long width, long height,
                  const std::vector<std::string>& channels, std::size_t max_values) {
    check_image_size(name, width, height, channels.size(), max_values);
    Image image{static_cast<int>(width), static_cast<int>(height), {}, {}};
    for (const std::string& channel : channels) {
        image.channels.push_back({channel, std::vector<float>(image.pixel_count())});
    }
    return image;
}

bool looks_like_image(std::string_view bytes) {
    return looks_like_exr(bytes) || looks_like_png(bytes) || looks_like_radiance_hdr(bytes);
}

Image parse_image(std::string_view bytes, const std::string& name, std::size_t max_values) {
    if (looks_like_exr(bytes)) return parse_exr(bytes, name, max_values);
    if (looks_like_png(bytes)) return parse_png(bytes, name, max_values);
    if (looks_like_radiance_hdr(bytes)) return parse_radiance_hdr(bytes, name, max_values);
    throw InputError(
        fmt::format("{}: is not a picture; OpenEXR, Radiance HDR and PNG can be read", name));
}

Image read_image(const std::filesystem::path& path, std::size_t max_values) {
    return parse_image(read_file(path, kMaxImageFileBytes), path.string(), max_values);
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

double soft_shoulder(double light) {
    if (!(light > 0)) return 0;
    if (light <= kShoulderStart) return light;
    constexpr double kRoom = 1 - kShoulderStart;
    return kShoulderStart - kRoom * std::expm1(-(light - kShoulderStart) / kRoom);
}

unsigned char display_byte(double light, double exposure_scale) {
    const double encoded = spectra::srgb_encode(soft_shoulder(light * exposure_scale));
    return static_cast<unsigned char>(std::lround(255 * encoded));
}

double outside_gamut(const Image& image, spectra::Gamut gamut) {
    const std::vector<float> rgb = interleaved_rgb(image, "picture");
    constexpr double kRounding = 1e-3;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        const Vec3d shown = spectra::rec709_to(gamut, {rgb[i], rgb[i + 1], rgb[i + 2]});
        const auto [least, largest] = std::minmax({shown[0], shown[1], shown[2]});
        outside += least < -kRounding * std::max(largest, 0.0);
    }
    return rgb.empty() ? 0 : 3 * static_cast<double>(outside) / static_cast<double>(rgb.size());
}

void write_png(const std::filesystem::path& path, const Image& image, const ToneMap& tone_map) {
    write_file_atomically(path, encode_png(image, path.string(), tone_map));
}

std::filesystem::path png_beside(const std::filesystem::path& exr) {
    return std::filesystem::path(exr).replace_extension(".png");
}

namespace {

constexpr std::string_view kOwnKey = "nacre:";

}  // namespace

bool is_own_picture(std::string_view bytes, const std::string& name) {
    try {
        std::map<std::string, std::string> metadata;
        if (looks_like_png(bytes)) {
            metadata = png_texts(bytes, name);
        } else if (looks_like_exr(bytes)) {
            metadata = parse_exr(bytes, name, kMaxImageValues).metadata;
        }
        const auto first = metadata.lower_bound(std::string(kOwnKey));
        return first != metadata.end() && first->first.starts_with(kOwnKey);
    } catch (const InputError&) {
        return false;
    }
}

void check_png_beside(const std::filesystem::path& png) {
    if (!std::filesystem::is_regular_file(png)) return;
    bool own = false;
    try {
        own = is_own_picture(read_file(png, kMaxImageFileBytes), png.string());
    } catch (const InputError&) {  // too large: not as Nacre writes them
    }
    if (own) return;
    throw InputError(
        fmt::format("cannot write '{}' beside the EXR: there is such a file, which Nacre did not "
                    "make; rename or remove it, or give the EXR another name",
                    png.string()));
}

std::string rgb_sha256(const Image& image) {
    const std::vector<float> rgb = interleaved_rgb(image, "picture");
    return sha256_hex({reinterpret_cast<const char*>(rgb.data()), sizeof(float) * rgb.size()});
}

void write_exr_and_png(const std::filesystem::path& exr, Image image, const ToneMap& tone_map) {
    image.metadata.emplace("nacre:version", version());
    const std::filesystem::path png = png_beside(exr);
    check_png_beside(png);
    image.metadata["nacre:rgb_sha256"] = rgb_sha256(image);
    write_together(
        {{exr, encode_exr(image, exr.string())}, {png, encode_png(image, png.string(), tone_map)}});
}

}  // namespace nacre::io
