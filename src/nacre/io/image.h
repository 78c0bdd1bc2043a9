#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/spectra/rgb.h"

// Pictures of linear light. Pixels are row-major from the top left; R, G, B are linear Rec. 709,
// where 1 is the perfect diffuser in full light.

namespace nacre::io {

struct Channel {
    std::string name;  ///< "R", "albedo.R", "S0.550,000000nm"; the part up to the dot is its layer
    std::vector<float> pixels;

    friend bool operator==(const Channel&, const Channel&) = default;
};

struct Image {
    int width = 0, height = 0;
    std::vector<Channel> channels = {};
    std::map<std::string, std::string> metadata = {};  ///< kept by EXR and PNG

    std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// The channel of that name, or null.
    const Channel* find(std::string_view name) const;

    friend bool operator==(const Image&, const Image&) = default;
};

/// Of every picture that is read, rendered or written.
inline constexpr int kMaxPixelsPerSide = 32768;
inline constexpr std::size_t kMaxChannels = 1024;
/// Pixels times channels that a file may unfold to: 2 GB.
inline constexpr std::size_t kMaxImageValues = std::size_t{1} << 29;

inline constexpr std::size_t kMaxImageFileBytes = std::size_t{1} << 30;

/// Reads OpenEXR (the first part, scan lines or tiles, every channel), Radiance HDR (RGBE) or PNG
/// (8 and 16 bit, decoded from sRGB, from Display P3 and Rec. 2020 where its chunk cICP names them;
/// transparency is laid over black), whichever the contents are.
///
/// @throws InputError if the file is none of these, is cut short or damaged, or unfolds to more
///         than `max_values` values
Image read_image(const std::filesystem::path& path, std::size_t max_values = kMaxImageValues);
/// The same from the bytes of a file; `name` is for messages.
Image parse_image(std::string_view bytes, const std::string& name,
                  std::size_t max_values = kMaxImageValues);

/// Whether the bytes start like a picture that parse_image() reads.
bool looks_like_image(std::string_view bytes);

/// R, G and B interleaved, three values a pixel; a picture of the one channel Y is taken as gray.
/// @throws InputError naming `name` if the picture has neither
std::vector<float> interleaved_rgb(const Image& image, const std::string& name);

/// Writes every channel in 32 bits with lossless compression, and the metadata as text
/// attributes; whole or not at all.
/// @throws DomainError if channel sizes do not fit the picture
/// @throws Error if the file cannot be written
void write_exr(const std::filesystem::path& path, const Image& image);

/// The bytes that write_exr() writes; `name` is for messages.
/// @throws DomainError if channel sizes do not fit the picture
std::string encode_exr(const Image& image, const std::string& name);

/// Of ToneMap::exposure_stops, where users choose it.
inline constexpr Range kExposureRange{-50, 50, "stops"};

/// How linear light becomes eight bits.
struct ToneMap {
    double exposure_stops = 0;  ///< light is first multiplied by 2 to this power
    /// The primaries of the display; other than sRGB's are named in the file by its chunks cICP and
    /// cHRM, without which it would look pale.                            [png-3-2025]
    spectra::Gamut gamut = spectra::Gamut::rec709;

    friend bool operator==(const ToneMap&, const ToneMap&) = default;
};

/// The fraction of pixels with a colour that the display does not have: a component below 0 by more
/// than a thousandth of the largest, which the PNG shows as 0.
/// @throws InputError as interleaved_rgb()
double outside_gamut(const Image& image, spectra::Gamut gamut);

/// Writes R, G and B, tone-mapped to the display's transfer function of sRGB, and the metadata as text chunks; whole or not at all.
/// Errors as for write_exr() and interleaved_rgb().
void write_png(const std::filesystem::path& path, const Image& image, const ToneMap& tone_map = {});

/// The bytes that write_png() writes; `name` is for messages.
/// @throws InputError as interleaved_rgb()
std::string encode_png(const Image& image, const std::string& name, const ToneMap& tone_map = {});

/// The name of the PNG that is put beside an EXR to look at.
std::filesystem::path png_beside(const std::filesystem::path& exr);

/// Whether Nacre wrote an EXR or a PNG, which shows in an attribute, or a text chunk, whose name
/// begins with "nacre:". Not if it is damaged.
bool is_own_picture(std::string_view bytes, const std::string& name);

/// Refuses to replace a picture of the user's: the PNG beside an EXR is named by nobody. It may be
/// replaced if it is_own_picture().
/// @throws InputError naming the file if there is one that Nacre did not write
void check_png_beside(const std::filesystem::path& png);

/// Of R, G and B pixel by pixel, as little-endian floats: tells which files show one picture.
/// @throws DomainError if a channel is missing
std::string rgb_sha256(const Image& image);

/// Writes an EXR as write_exr() and the PNG beside it as write_png(), with "nacre:version" added to
/// the metadata of both if it is missing, and "nacre:rgb_sha256", by which the two are
/// known for a pair. Neither file is replaced
/// before both are on the disk.
/// @throws InputError as check_png_beside(); what write_exr() and write_png() throw
void write_exr_and_png(const std::filesystem::path& exr, Image image, const ToneMap& tone_map = {});

/// Name of the channel of a spectral radiance at a wavelength, as in "S0.550,000000nm".
///                                                                   [fichet-2021, section 3]
std::string spectral_channel_name(double wavelength_nm);

// One reader per picture format; parse_image() picks among them.

bool looks_like_exr(std::string_view bytes);
bool looks_like_png(std::string_view bytes);
bool looks_like_radiance_hdr(std::string_view bytes);

Image parse_exr(std::string_view bytes, const std::string& name, std::size_t max_values);
/// What a PNG says of itself, by keyword. @throws InputError if its chunks are damaged
std::map<std::string, std::string> png_texts(std::string_view bytes, const std::string& name);
Image parse_png(std::string_view bytes, const std::string& name, std::size_t max_values);
Image parse_radiance_hdr(std::string_view bytes, const std::string& name, std::size_t max_values);

/// @throws InputError naming `name` if a picture of that size is absurd or has more than
///         `max_values` values
void check_image_size(const std::string& name, long width, long height, std::size_t channels,
                      std::size_t max_values);

/// An image with the given channels, all zero.
/// @throws InputError as check_image_size()
Image blank_image(const std::string& name, long width, long height,
                  const std::vector<std::string>& channels, std::size_t max_values);

/// Where the shoulder of the tone curve starts: below, light is shown as it is.
inline constexpr double kShoulderStart = 0.8;

/// Linear light in [0, inf) to linear light on a display in [0, 1): the identity up to s =
/// kShoulderStart, then s + (1 - s)(1 - exp(-(x - s)/(1 - s))), which continues it with the same
/// slope and never burns out. Negative light, from colours outside the gamut, becomes 0.
double soft_shoulder(double light);

/// The whole way to eight bits: exposure, shoulder, sRGB transfer function, rounding.
/// NaN is shown as 0.                                                      [iec-61966-2-1-1999]
unsigned char display_byte(double light, double exposure_scale);

}  // namespace nacre::io
