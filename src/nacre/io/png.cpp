#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <memory>

#include "nacre/core/error.h"
#include "nacre/io/image.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

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

std::map<std::string, std::string> png_texts(std::string_view bytes, const std::string& name) {
    return texts(chunks(bytes, name));
}

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

}  // namespace nacre::io
