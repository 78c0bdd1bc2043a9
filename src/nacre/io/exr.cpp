#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <stdexcept>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/exr_guard.h"
#include "nacre/io/image_formats.h"

namespace nacre::io {

namespace {

constexpr std::string_view kMagic = "\x76\x2f\x31\x01";

/// OpenEXR reads from bytes in memory: the file has been read, and bounded, before.
class MemoryStream : public Imf::IStream {
 public:
    MemoryStream(std::string_view bytes, const std::string& name)
        : Imf::IStream(name.c_str()), bytes_(bytes) {}

    bool read(char c[], int n) override {
        if (n < 0 || static_cast<std::size_t>(n) > bytes_.size() - at_) {
            throw std::runtime_error("the file ends too early");
        }
        std::memcpy(c, bytes_.data() + at_, static_cast<std::size_t>(n));
        at_ += static_cast<std::size_t>(n);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t pos) override {
        if (pos > bytes_.size()) throw std::runtime_error("an offset beyond the end of the file");
        at_ = static_cast<std::size_t>(pos);
    }

 private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

Imf::Slice slice_of(std::vector<float>& pixels, const Imath::Box2i& window, std::size_t width) {
    return Imf::Slice::Make(Imf::FLOAT, pixels.data(), window, sizeof(float),
                            sizeof(float) * width);
}

Image read_pixels(Imf::InputFile& file, const std::string& name, std::size_t most_values) {
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();
    std::vector<std::string> channels;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        if (i.channel().xSampling != 1 || i.channel().ySampling != 1) {
            throw InputError(fmt::format("{}: channel {} is subsampled, which is not supported",
                                         name, i.name()));
        }
        channels.emplace_back(i.name());
    }
    // In 64 bits: a damaged window may span all of int.
    const long width = static_cast<long>(window.max.x) - window.min.x + 1;
    const long height = static_cast<long>(window.max.y) - window.min.y + 1;
    Image image = blank_image(name, width, height, channels, most_values);
    Imf::FrameBuffer frame;
    for (Channel& channel : image.channels) {
        frame.insert(channel.name,
                     slice_of(channel.pixels, window, static_cast<std::size_t>(width)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    for (auto i = header.begin(); i != header.end(); ++i) {
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute())) {
            image.metadata[i.name()] = text->value();
        }
    }
    return image;
}

}  // namespace

bool looks_like_exr(std::string_view bytes) { return bytes.starts_with(kMagic); }

Image parse_exr(std::string_view bytes, const std::string& name, std::size_t most_values) {
    try {
        check_exr_headers(bytes, name, most_values);
        MemoryStream stream(bytes, name);
        Imf::InputFile file(stream, 0);
        return read_pixels(file, name, most_values);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {  // OpenEXR's own are of this type too
        throw InputError(fmt::format("{}: damaged OpenEXR picture: {}", name, error.what()));
    }
}

void write_exr(const std::filesystem::path& path, const Image& image) {
    if (image.width < 1 || image.height < 1) {
        throw DomainError(fmt::format("picture of {} x {} pixels", image.width, image.height));
    }
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    for (const Channel& channel : image.channels) {
        if (channel.pixels.size() != image.pixel_count()) {
            throw DomainError(fmt::format("channel {} has {} pixels; the picture has {}",
                                          channel.name, channel.pixels.size(),
                                          image.pixel_count()));
        }
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        // The slice is only read from; OpenEXR has one type for both ways.
        auto& pixels = const_cast<std::vector<float>&>(channel.pixels);
        frame.insert(channel.name,
                     slice_of(pixels, header.dataWindow(), static_cast<std::size_t>(image.width)));
    }
    for (const auto& [key, value] : image.metadata) {
        header.insert(key, Imf::StringAttribute(value));
    }
    AtomicFile target(path);
    try {
        Imf::OutputFile file(target.temporary_path().c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    } catch (const std::exception& error) {
        throw Error(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
    target.commit();
}

}  // namespace nacre::io
