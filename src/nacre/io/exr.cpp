#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/image.h"

namespace nacre::io {

/// Looks through the headers of an OpenEXR file before the OpenEXR library does, which allocates
/// whatever sizes it finds there: a file of a kilobyte could ask for gigabytes.
///
/// @throws InputError naming `name` if an attribute is larger than the file, or if the picture, one
///         of its tiles or a block of its scan lines has more than `max_values` values
void check_exr_headers(std::string_view bytes, const std::string& name, std::size_t max_values);

namespace {

constexpr std::string_view kExrMagic = "\x76\x2f\x31\x01";

/// OpenEXR reads from bytes in memory: the file has been read, and bounded, before.
class MemoryStream : public Imf::IStream {
 public:
    MemoryStream(std::string_view bytes, const std::string& name)
        : Imf::IStream(name.c_str()), bytes_(bytes) {}

    bool read(char c[], int n) override {
        if (n < 0 || static_cast<std::size_t>(n) > bytes_.size() - at_) {
            throw Error("the file ends too early");
        }
        std::memcpy(c, bytes_.data() + at_, static_cast<std::size_t>(n));
        at_ += static_cast<std::size_t>(n);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t pos) override {
        if (pos > bytes_.size()) throw Error("an offset beyond the end of the file");
        at_ = static_cast<std::size_t>(pos);
    }

 private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// OpenEXR writes into memory. Its own files report errors while it closes them, in a destructor that
/// drops them; a picture that a full disk had cut short would pass for whole.
class MemoryOutput : public Imf::OStream {
 public:
    explicit MemoryOutput(const std::string& name) : Imf::OStream(name.c_str()) {}

    void write(const char c[], int n) override {
        const std::string_view more(c, static_cast<std::size_t>(n));
        bytes_.replace(at_, std::min(more.size(), bytes_.size() - at_), more);
        at_ += more.size();
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t pos) override {
        if (pos > bytes_.size()) throw Error("an offset beyond the end of the file");
        at_ = static_cast<std::size_t>(pos);
    }
    std::string take() { return std::move(bytes_); }

 private:
    std::string bytes_;
    std::size_t at_ = 0;
};

Imf::Slice slice_of(std::vector<float>& pixels, const Imath::Box2i& window, std::size_t width) {
    return Imf::Slice::Make(Imf::FLOAT, pixels.data(), window, sizeof(float),
                            sizeof(float) * width);
}

Image read_pixels(Imf::InputFile& file, const std::string& name, std::size_t max_values) {
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
    Image image = blank_image(name, width, height, channels, max_values);
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

bool looks_like_exr(std::string_view bytes) { return bytes.starts_with(kExrMagic); }

Image parse_exr(std::string_view bytes, const std::string& name, std::size_t max_values) {
    try {
        check_exr_headers(bytes, name, max_values);
        MemoryStream stream(bytes, name);
        Imf::InputFile file(stream, 0);
        return read_pixels(file, name, max_values);
    } catch (const InputError&) {  // names the file
        throw;
    } catch (const std::exception& error) {  // MemoryStream's and OpenEXR's own
        throw InputError(fmt::format("{}: damaged OpenEXR picture: {}", name, error.what()));
    }
}

std::string encode_exr(const Image& image, const std::string& name) {
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
    MemoryOutput stream(name);
    try {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    } catch (const std::exception& error) {
        throw Error(fmt::format("cannot write '{}': {}", name, error.what()));
    }
    return stream.take();
}

void write_exr(const std::filesystem::path& path, const Image& image) {
    write_file_atomically(path, encode_exr(image, path.string()));
}

// Layout of the file: magic and version, four bytes each; then a header of attributes (name, 0,
// type, 0, size, value), ended by an empty name; with the flag "multi-part" several headers, ended
// by an empty one. Numbers are little-endian, as this program's machines are.

namespace {

constexpr std::uint32_t kMultiPart = 0x1000;
constexpr std::size_t kChannelBytes = 16;  // what follows a channel's name
constexpr char kDwab = 9;                  // the compression with the tallest blocks

/// Types whose values always take the same number of bytes. OpenEXR reads that many, whatever size
/// the file states: with another one it would go on in the middle of a value, and take what it
/// finds there for the size of the next.
struct FixedSizeType {
    std::string_view name;
    std::size_t bytes;
};
constexpr std::array kFixedSizeTypes = {
    FixedSizeType{"box2f", 16},
    FixedSizeType{"box2i", 16},
    FixedSizeType{"chromaticities", 32},
    FixedSizeType{"compression", 1},
    FixedSizeType{"deepImageState", 1},
    FixedSizeType{"double", 8},
    FixedSizeType{"envmap", 1},
    FixedSizeType{"float", 4},
    FixedSizeType{"int", 4},
    FixedSizeType{"keycode", 28},
    FixedSizeType{"lineOrder", 1},
    FixedSizeType{"m33d", 72},
    FixedSizeType{"m33f", 36},
    FixedSizeType{"m44d", 128},
    FixedSizeType{"m44f", 64},
    FixedSizeType{"rational", 8},
    FixedSizeType{"tiledesc", 9},
    FixedSizeType{"timecode", 8},
    FixedSizeType{"v2d", 16},
    FixedSizeType{"v2f", 8},
    FixedSizeType{"v2i", 8},
    FixedSizeType{"v3d", 24},
    FixedSizeType{"v3f", 12},
    FixedSizeType{"v3i", 12},
};
/// Buffers of this many values are allowed however small the picture is.
constexpr std::size_t kSmallBuffer = std::size_t{1} << 22;

class HeaderScan {
 public:
    HeaderScan(std::string_view bytes, const std::string& name, std::size_t max_values)
        : rest_(bytes), name_(name), max_values_(max_values) {}

    void run() {
        take(4);
        const bool multi_part = (number<std::uint32_t>(take(4)) & kMultiPart) != 0;
        do {
            one_header();
        } while (multi_part && !rest_.empty() && rest_[0] != '\0');
    }

 private:
    [[noreturn]] void fail(std::string_view why) const {
        throw InputError(fmt::format("{}: damaged OpenEXR picture: {}", name_, why));
    }

    std::string_view take(std::size_t count) {
        if (count > rest_.size()) fail("an attribute is larger than the file");
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }

    std::string_view take_text() {
        const std::size_t zero = rest_.find('\0');
        if (zero == std::string_view::npos) fail("its header does not end");
        const std::string_view text = take(zero);
        take(1);
        return text;
    }

    template <class T>
    T number(std::string_view bytes) const {
        T value{};
        if (bytes.size() < sizeof value) fail("an attribute is too short");
        std::memcpy(&value, bytes.data(), sizeof value);
        return value;
    }

    void one_header() {
        long width = 0, height = 0;
        std::size_t channels = 0, tile_values = 0, block_lines = 32;
        for (std::string_view key = take_text(); !key.empty(); key = take_text()) {
            const std::string_view type = take_text();
            const std::string_view value = take(number<std::uint32_t>(take(4)));
            check_size(type, value);
            if (key == "dataWindow") {
                const auto box = number<std::array<std::int32_t, 4>>(value);
                width = static_cast<long>(box[2]) - box[0] + 1;
                height = static_cast<long>(box[3]) - box[1] + 1;
            } else if (key == "channels") {
                channels = channel_count(value);
            } else if (key == "tiles") {
                const auto size = number<std::array<std::uint32_t, 2>>(value);
                tile_values = std::size_t{size[0]} * size[1];
            } else if (key == "compression" && !value.empty() && value[0] == kDwab) {
                block_lines = 256;
            }
        }
        check_image_size(name_, width, height, channels, max_values_);
        const std::size_t max_buffer = std::max(max_values_, kSmallBuffer);
        if (tile_values > max_buffer / channels) fail("its tiles are too large");
        if (static_cast<std::size_t>(width) * block_lines > max_buffer / channels) {
            fail("its blocks of scan lines are too large");
        }
    }

    /// Refuses a value that OpenEXR would not read exactly to its end.
    void check_size(std::string_view type, std::string_view value) const {
        const auto fixed = std::ranges::find(kFixedSizeTypes, type, &FixedSizeType::name);
        bool fits = true;
        if (fixed != kFixedSizeTypes.end()) {
            fits = value.size() == fixed->bytes;
        } else if (type == "floatvector") {
            fits = value.size() % sizeof(float) == 0;
        } else if (type == "preview") {  // width, height, four bytes a pixel
            const auto size = number<std::array<std::uint32_t, 2>>(value);
            const std::size_t pixels = (value.size() - sizeof size) / 4;
            fits =
                (value.size() - sizeof size) % 4 == 0 &&
                (size[1] == 0 ? pixels == 0 : pixels % size[1] == 0 && pixels / size[1] == size[0]);
        } else if (type == "chlist") {
            channel_count(value);
        } else if (type == "stringvector") {  // strings, each after its length
            while (fits && !value.empty()) {
                const std::size_t length = number<std::uint32_t>(value);
                fits = length <= value.size() - 4;
                if (fits) value.remove_prefix(4 + length);
            }
        }
        if (!fits) fail(fmt::format("an attribute of type '{}' has the wrong size", type));
    }

    std::size_t channel_count(std::string_view list) const {
        std::size_t count = 0;
        while (!list.empty() && list[0] != '\0') {
            const std::size_t zero = list.find('\0');
            if (zero == std::string_view::npos || list.size() - zero - 1 < kChannelBytes) {
                fail("its list of channels is cut short");
            }
            list.remove_prefix(zero + 1 + kChannelBytes);
            ++count;
        }
        if (list.size() != 1) fail("its list of channels does not end where it should");
        return count;
    }

    std::string_view rest_;
    std::string name_;
    std::size_t max_values_;
};

}  // namespace

void check_exr_headers(std::string_view bytes, const std::string& name, std::size_t max_values) {
    HeaderScan(bytes, name, max_values).run();
}

}  // namespace nacre::io
