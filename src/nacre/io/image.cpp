#include "nacre/io/image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>

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

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

struct Chunk {
    std::string_view type, data;
};

/// The chunks: length, type, data, checksum. libpng allocates the lengths that it finds, so a file
/// whose chunks do not fit into it is refused before.
std::vector<Chunk> chunks(std::string_view bytes, const std::string& name) {
    std::vector<Chunk> found;
    bytes.remove_prefix(kSignature.size());
    while (bytes.size() >= 12 && (found.empty() || found.back().type != "IEND")) {
        const std::size_t length = big_endian(bytes);
        if (length > bytes.size() - 12) {
            throw InputError(fmt::format("{}: damaged PNG: a chunk is larger than the file", name));
        }
        found.push_back({bytes.substr(4, 4), bytes.substr(8, length)});
        bytes.remove_prefix(length + 12);
    }
    return found;
}

/// The uncompressed texts: keyword, 0, text.
std::map<std::string, std::string> texts(const std::vector<Chunk>& chunks) {
    std::map<std::string, std::string> found;
    for (const Chunk& chunk : chunks) {
        const std::size_t zero = chunk.data.find('\0');
        if (chunk.type != "tEXt" || zero == std::string_view::npos) continue;
        found[std::string(chunk.data.substr(0, zero))] = chunk.data.substr(zero + 1);
    }
    return found;
}

/// Everything a PNG writer holds, so that it is released on every way out.
struct PngWriter {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    std::string complaint;

    ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

// libpng is C: it must not see an exception. An error is kept, and a long jump ends the work.
void on_error(png_structp png, png_const_charp message) {
    static_cast<PngWriter*>(png_get_error_ptr(png))->complaint = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}
void on_write(png_structp png, png_bytep data, std::size_t count) {
    try {
        static_cast<PngWriter*>(png_get_io_ptr(png))
            ->bytes.append(reinterpret_cast<const char*>(data), count);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");
    }
}
void on_flush(png_structp) {}

// Code points of cICP.                                           [itu-h-273-2021; png-3-2025]
constexpr png_byte kCicpRec709 = 1, kCicpRec2020 = 9, kCicpP3 = 12, kCicpSrgbTransfer = 13;

/// Encodes; between setjmp and the end only C functions run and no object is made, as a long jump
/// past a destructor is undefined.
bool encode(PngWriter& writer, std::uint32_t width, std::uint32_t height, png_textp texts,
            int text_count, spectra::Gamut gamut, const std::uint8_t* pixels) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_write_fn(writer.png, &writer, on_write, on_flush);
    png_set_IHDR(writer.png, writer.info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (gamut == spectra::Gamut::rec709) {
        png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    } else {
        const auto& xy = spectra::primaries(gamut);
        const double* white = spectra::kRec709White;
        png_set_cHRM(writer.png, writer.info, white[0], white[1], xy[0][0], xy[0][1], xy[1][0],
                     xy[1][1], xy[2][0], xy[2][1]);
        png_set_gAMA(writer.png, writer.info, 1 / 2.2);
        png_write_info_before_PLTE(writer.png, writer.info);
        const png_byte code[] = {gamut == spectra::Gamut::display_p3 ? kCicpP3 : kCicpRec2020,
                                 kCicpSrgbTransfer, 0, 1};
        png_write_chunk(writer.png, reinterpret_cast<png_const_bytep>("cICP"), code, sizeof code);
    }
    if (text_count > 0) png_set_text(writer.png, writer.info, texts, text_count);
    png_write_info(writer.png, writer.info);
    for (std::uint32_t y = 0; y < height; ++y) {
        png_write_row(writer.png, pixels + static_cast<std::size_t>(3) * width * y);
    }
    png_write_end(writer.png, writer.info);
    return true;
}

/// Keeps what PNG allows in a keyword: up to 79 printable characters.
std::string keyword(const std::string& text) {
    std::string out = text.substr(0, 79);
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 33 || static_cast<unsigned char>(c) > 126) c = '_';
    }
    return out.empty() ? "_" : out;
}

std::string png_bytes(const std::vector<std::uint8_t>& pixels, int width, int height,
                      spectra::Gamut gamut, const std::map<std::string, std::string>& metadata) {
    PngWriter writer;
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, on_error, on_warning);
    if (writer.png) writer.info = png_create_info_struct(writer.png);
    if (!writer.info) throw Error("cannot start libpng");

    std::vector<std::pair<std::string, std::string>> owned;
    for (const auto& [key, value] : metadata) owned.emplace_back(keyword(key), value);
    std::vector<png_text> texts(owned.size());
    for (std::size_t i = 0; i < owned.size(); ++i) {
        texts[i].compression = PNG_TEXT_COMPRESSION_NONE;
        texts[i].key = owned[i].first.data();
        texts[i].text = owned[i].second.data();
        texts[i].text_length = owned[i].second.size();
    }
    if (!encode(writer, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                texts.data(), static_cast<int>(texts.size()), gamut, pixels.data())) {
        throw Error(fmt::format("cannot encode a PNG: {}", writer.complaint));
    }
    return std::move(writer.bytes);
}

/// What cICP says; sRGB without it.
spectra::Gamut gamut_of(const std::vector<Chunk>& chunks, const std::string& name) {
    for (const Chunk& chunk : chunks) {
        if (chunk.type != "cICP") continue;
        const auto code = [&](std::size_t i) {
            return i < chunk.data.size() ? static_cast<unsigned char>(chunk.data[i]) : 0u;
        };
        if (code(1) == kCicpSrgbTransfer && code(2) == 0) {
            if (code(0) == kCicpRec709) return spectra::Gamut::rec709;
            if (code(0) == kCicpP3) return spectra::Gamut::display_p3;
            if (code(0) == kCicpRec2020) return spectra::Gamut::rec2020;
        }
        throw InputError(fmt::format(
            "{}: its colours are of primaries {} and transfer function {} (chunk cICP); "
            "read are primaries 1 (Rec. 709), 9 (Rec. 2020) and 12 (P3) with transfer "
            "function 13 (sRGB)",
            name, code(0), code(1)));
    }
    return spectra::Gamut::rec709;
}

void turn_to_rec709(spectra::Gamut gamut, Image& image) {
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        Vec3d rgb{};
        for (int c = 0; c < 3; ++c) rgb[c] = image.channels[c].pixels[p];
        rgb = spectra::to_rec709(gamut, rgb);
        for (int c = 0; c < 3; ++c) image.channels[c].pixels[p] = static_cast<float>(rgb[c]);
    }
}

const std::array<float, 256>& decoded_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (int i = 0; i < 256; ++i) t[i] = static_cast<float>(spectra::srgb_decode(i / 255.0));
        return t;
    }();
    return table;
}

}  // namespace

bool looks_like_png(std::string_view bytes) { return bytes.starts_with(kSignature); }

Image parse_png(std::string_view bytes, const std::string& name, std::size_t max_values) {
    const std::vector<Chunk> all_chunks = chunks(bytes, name);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, void (*)(png_image*)> guard(&png, png_image_free);
    const auto fail = [&] {
        throw InputError(fmt::format("{}: damaged PNG: {}", name, png.message));
    };
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) fail();
    Image image = blank_image(name, png.width, png.height, {"R", "G", "B"}, max_values);
    image.metadata = texts(all_chunks);
    const spectra::Gamut gamut = gamut_of(all_chunks, name);
    const std::size_t values = 3 * image.pixel_count();
    const auto store = [&](const auto& pixels, auto&& decode) {
        for (std::size_t i = 0; i < values; ++i) {
            image.channels[i % 3].pixels[i / 3] = decode(pixels[i]);
        }
    };
    // Files of 16 bits keep their depth. Transparency is blended with the zeros in the buffer.
    if (png.format & PNG_FORMAT_FLAG_LINEAR) {
        png.format = PNG_FORMAT_LINEAR_RGB;
        std::vector<std::uint16_t> pixels(values);
        if (!png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr)) fail();
        store(pixels, [](std::uint16_t v) { return static_cast<float>(v) / 65535.0f; });
    } else {
        png.format = PNG_FORMAT_RGB;
        std::vector<std::uint8_t> pixels(values);
        if (!png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr)) fail();
        store(pixels, [](std::uint8_t v) { return decoded_bytes()[v]; });
    }
    if (gamut != spectra::Gamut::rec709) turn_to_rec709(gamut, image);
    return image;
}

std::string encode_png(const Image& image, const std::string& name, const ToneMap& tone_map) {
    const std::vector<float> rgb = interleaved_rgb(image, name);
    const double scale = std::exp2(tone_map.exposure_stops);
    std::vector<std::uint8_t> pixels(rgb.size());
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        const Vec3d shown = spectra::rec709_to(tone_map.gamut, {rgb[i], rgb[i + 1], rgb[i + 2]});
        for (int c = 0; c < 3; ++c) pixels[i + c] = display_byte(shown[c], scale);
    }
    return png_bytes(pixels, image.width, image.height, tone_map.gamut, image.metadata);
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
            metadata = texts(chunks(bytes, name));
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

// Radiance's picture format: a header of text lines, then scan lines of shared-exponent pixels
// (RGBE), run-length coded in one of two ways [ward-1991]. A mantissa m is read as m + 1/2, the
// middle of its step, as by Radiance's own programs.

namespace {

constexpr std::size_t kMaxHeaderBytes = 1 << 16;

class HdrReader {
 public:
    HdrReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Image read(std::size_t max_values) {
        read_header();
        Image image = blank_image(name_, width_, height_, {"R", "G", "B"}, max_values);
        line_.resize(4 * static_cast<std::size_t>(width_));
        for (long y = 0; y < height_; ++y) {
            read_scan_line();
            store(image, static_cast<std::size_t>(y));
        }
        return image;
    }

 private:
    [[noreturn]] void fail(std::string_view why) const {
        throw InputError(
            fmt::format("{}: damaged Radiance picture: {}, at byte {}", name_, why, at_));
    }

    std::uint8_t byte() {
        if (at_ >= bytes_.size()) fail("it ends too early");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }

    std::string text_line() {
        const std::size_t end = bytes_.substr(0, kMaxHeaderBytes).find('\n', at_);
        if (end == std::string_view::npos) fail("its header does not end");
        std::string line(bytes_.substr(at_, end - at_));
        at_ = end + 1;
        return line;
    }

    void read_header() {
        text_line();  // "#?RADIANCE", already seen
        for (std::string line = text_line(); !line.empty(); line = text_line()) {
            if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
                fail("only FORMAT=32-bit_rle_rgbe can be read");
            }
            if (line.starts_with("EXPOSURE=")) {
                const double exposure = std::strtod(line.c_str() + 9, nullptr);
                if (!(exposure > 1e-30 && exposure < 1e30)) fail("bad EXPOSURE");
                scale_ /= exposure;  // pixels have been multiplied by each of these
            }
        }
        const std::string size = text_line();
        int end = 0;
        if (std::sscanf(size.c_str(), "-Y %9ld +X %9ld%n", &height_, &width_, &end) != 2 ||
            static_cast<std::size_t>(end) != size.size()) {
            fail("only the orientation '-Y height +X width' can be read");
        }
    }

    void read_scan_line() {
        const std::size_t width = static_cast<std::size_t>(width_);
        // Separate runs for each component, marked by 2 2 and the width; else the older coding.
        if (width >= 8 && width < 32768 && bytes_.size() - at_ >= 4 && bytes_[at_] == 2 &&
            bytes_[at_ + 1] == 2 && static_cast<std::uint8_t>(bytes_[at_ + 2]) < 128) {
            at_ += 2;
            const std::size_t hi = byte(), lo = byte();
            if ((hi << 8 | lo) != width) fail("a scan line of another width");
            for (std::size_t component = 0; component < 4; ++component) read_runs(component);
        } else {
            read_old_scan_line();
        }
    }

    void read_runs(std::size_t component) {
        const std::size_t width = static_cast<std::size_t>(width_);
        for (std::size_t x = 0; x < width;) {
            std::size_t count = byte();
            const bool run = count > 128;
            if (run) count &= 127;
            if (count == 0 || count > width - x) fail("a run that does not fit its scan line");
            std::uint8_t value = run ? byte() : 0;
            for (; count > 0; --count, ++x) {
                if (!run) value = byte();
                line_[4 * x + component] = value;
            }
        }
    }

    void read_old_scan_line() {
        const std::size_t width = static_cast<std::size_t>(width_);
        int shift = 0;  // runs that follow each other are the digits of one count, base 256
        for (std::size_t x = 0; x < width;) {
            std::uint8_t pixel[4];
            for (std::uint8_t& component : pixel) component = byte();
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                std::copy(pixel, pixel + 4, line_.begin() + static_cast<std::ptrdiff_t>(4 * x));
                ++x;
                shift = 0;
                continue;
            }
            if (x == 0 || shift > 16) fail("a run that repeats nothing");
            const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
            if (count > width - x) fail("a run that does not fit its scan line");
            for (std::size_t i = 0; i < 4 * count; ++i) line_[4 * x + i] = line_[4 * x + i - 4];
            x += count;
            shift += 8;
        }
    }

    void store(Image& image, std::size_t y) const {
        const std::size_t width = static_cast<std::size_t>(width_);
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t* rgbe = &line_[4 * x];
            const double unit = rgbe[3] == 0 ? 0 : scale_ * std::ldexp(1.0, rgbe[3] - 136);
            for (std::size_t c = 0; c < 3; ++c) {
                image.channels[c].pixels[y * width + x] =
                    static_cast<float>((rgbe[c] + 0.5) * unit);
            }
        }
    }

    std::string_view bytes_;
    std::string name_;
    std::size_t at_ = 0;
    long width_ = 0, height_ = 0;
    double scale_ = 1;
    std::vector<std::uint8_t> line_;
};

}  // namespace

bool looks_like_radiance_hdr(std::string_view bytes) {
    return bytes.starts_with("#?RADIANCE\n") || bytes.starts_with("#?RGBE\n");
}

Image parse_radiance_hdr(std::string_view bytes, const std::string& name, std::size_t max_values) {
    return HdrReader(bytes, name).read(max_values);
}

}  // namespace nacre::io
