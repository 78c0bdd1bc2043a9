#include "nacre/render/render_image.h"

#include <fmt/format.h>

#include "nacre/core/version.h"

namespace nacre::render {

namespace {

/// io::Channel `offset` of pixels that have `stride` values each.
io::Channel picked(const std::string& name, const std::vector<float>& values, std::size_t offset,
                   std::size_t stride) {
    io::Channel channel{name, std::vector<float>(values.size() / stride)};
    for (std::size_t i = 0; i < channel.pixels.size(); ++i) {
        channel.pixels[i] = values[i * stride + offset];
    }
    return channel;
}

void add_triple(io::Image& image, const std::string& prefix, const char* letters,
                const std::vector<float>& values) {
    for (std::size_t c = 0; c < 3 && !values.empty(); ++c) {
        image.channels.push_back(picked(prefix + letters[c], values, c, 3));
    }
}

}  // namespace

io::Image image_of(const RenderResult& result, std::map<std::string, std::string> metadata) {
    io::Image image{result.width, result.height, {}, std::move(metadata)};
    add_triple(image, "", "RGB", result.rgb);
    add_triple(image, "albedo.", "RGB", result.albedo);
    add_triple(image, "normal.", "XYZ", result.normal);
    add_triple(image, "sparkle.", "RGB", result.sparkle);
    if (!result.alpha.empty()) image.channels.push_back({"A", result.alpha});
    const std::size_t bins = result.bin_centres_nm.size();
    for (std::size_t bin = 0; bin < bins && !result.spectral.empty(); ++bin) {
        image.channels.push_back(picked(io::spectral_channel_name(result.bin_centres_nm[bin]),
                                        result.spectral, bin, bins));
    }
    if (bins > 0) {
        image.metadata["spectralLayoutVersion"] = "1.0";
        // Light here is relative to the perfect diffuser in full light, not in watts.
        image.metadata["emissiveUnits"] = "relative";
    }
    image.metadata["nacre:version"] = version();
    image.metadata["nacre:samples_per_pixel"] = fmt::format("{}", result.samples);
    if (result.noise) image.metadata["nacre:noise"] = fmt::format("{:.3g}", *result.noise);
    image.metadata["nacre:state"] = result.complete ? "complete" : "partial";
    return image;
}

}  // namespace nacre::render
