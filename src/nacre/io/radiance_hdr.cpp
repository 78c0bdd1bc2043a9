#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "nacre/core/error.h"
#include "nacre/io/image.h"

// Radiance's picture format: a header of text lines, then scan lines of shared-exponent pixels
// (RGBE), run-length coded in one of two ways [ward-1991]. A mantissa m is read as m + 1/2, the
// middle of its step, as by Radiance's own programs.

namespace nacre::io {
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
