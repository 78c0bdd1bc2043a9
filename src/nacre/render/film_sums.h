#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nacre/core/reproducible_sum.h"
#include "nacre/core/vec.h"

namespace nacre::render {

/// Three sums, of the components of a colour or of a direction.
template <class Sum>
struct SumTriple : std::array<Sum, 3> {
    void add(const SumTriple& other) {
        for (std::size_t c = 0; c < 3; ++c) (*this)[c].add(other[c]);
    }
    Vec3d value() const { return {(*this)[0].value(), (*this)[1].value(), (*this)[2].value()}; }
};

/// Sums over passes, the same for all pixels that had as many.
struct PassSums {
    int count = 0;
    SumTriple<LightSum> d65, albedo_d65;  ///< XYZ of D65
    std::vector<LightSum> bin_weights;    ///< by bin of the spectral film

    void add(const PassSums& other);
    friend bool operator==(const PassSums&, const PassSums&) = default;
};

/// What a picture, or a shard of its samples, is developed from: sums over passes and over the
/// paths of each pixel. They do not depend on the order, so that the sums of shards make those of
/// the whole, bit for bit.
struct FilmSums {
    FilmSums() = default;
    FilmSums(int width, int height, int spectral_bins, bool with_sparkle);

    /// @param other  of the same size, bins and channels
    void add(const FilmSums& other);
    std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }

    int width = 0, height = 0;
    PassSums passes;
    std::vector<SumTriple<LightSum>> xyz, albedo;
    std::vector<SumTriple<LightSum>> sparkle;  ///< XYZ; empty unless asked for
    std::vector<SumTriple<UnitSum>> normal;
    std::vector<std::uint32_t> met;      ///< paths that met a surface
    std::vector<std::uint32_t> invalid;  ///< paths whose light cannot be summed
    std::vector<LightSum> spectral;      ///< bins per pixel

    friend bool operator==(const FilmSums&, const FilmSums&) = default;
};

}  // namespace nacre::render
