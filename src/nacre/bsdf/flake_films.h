#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/optics/thin_film.h"

// The colours of single flakes whose films vary.

namespace nacre::bsdf {

/// FlakeFilms at eight wavelengths; without films that vary, 1.
class BoundFlakeFilms {
 public:
    BoundFlakeFilms() = default;

    bool vary() const { return !ratio_.empty(); }

    /// R of one flake over the mean of all; vary() only.
    /// @param cosine  w_i . h
    /// @param film    32 random bits of the flake
    FloatLanes ratio(float cosine, std::uint32_t film) const;

 private:
    friend class FlakeFilms;
    std::uint64_t sets_ = 0;
    int intervals_ = 0;
    float min_cosine_ = 0, per_cosine_ = 0;
    std::vector<FloatLanes> ratio_;  // [set][cosine]
};

/// Reflectance of single flakes of a platelet species, as ratios to the mean over the species.
///
/// A set of flakes represents the species. With one film that varies they are the medians of
/// kOneFilmSet equally probable parts of its thickness distribution; with more, kManyFilmsSet
/// points: two films make a Hammersley set [niederreiter-1992, section 3.1], further ones are Latin
/// hypercube samples [mckay-1979, section 2.3]. Ratios are to the mean over the set, so that their
/// mean is 1 at every cosine and wavelength: a sum over flakes has the mean that the solver
/// computed, and the set determines only its fluctuation. E[R R'] of two wavelengths is that of the
/// distribution to kOneFilmError and, for cores of 500 nm whose spread smooths their fringes, to
/// kManyFilmsError, of the geometric mean of E[R^2] and E[R'^2].
class FlakeFilms {
 public:
    static constexpr int kOneFilmSet = 64, kManyFilmsSet = 256;
    static constexpr double kOneFilmError = 0.01, kManyFilmsError = 0.06;
    static constexpr int kCosineIntervals = 64;
    /// Ratios that differ from 1 by less make no flake brighter than another.
    static constexpr float kAlike = 1e-5f;

    /// Whether any film varies: otherwise all flakes are equal and there is nothing to tabulate.
    static bool vary(const optics::Platelet& platelet);

    /// @param min_cosine  of w_i . h that will be asked for, in [0, 1)
    /// @param cosine_intervals  fewer are less exact where the mean of a fringe is next to nothing
    /// @throws DomainError, Stopped as optics::platelet_table()
    FlakeFilms(const optics::Platelet& platelet, const optics::Material& binder,
               std::span<const double> wavelengths_nm, double min_cosine,
               SharedProgress* work = nullptr, int cosine_intervals = kCosineIntervals);

    /// [set][cosine][wavelength], the last wavelength twice; cosines even from min_cosine() to 1.
    std::span<const float> ratios() const { return ratio_; }
    std::size_t sets() const { return sets_; }
    double min_cosine() const { return min_cosine_; }
    int cosine_intervals() const { return intervals_; }

    /// Whether flakes reflect alike although their films vary, as where an opaque core alone does.
    bool alike() const { return alike_; }

    BoundFlakeFilms bind(const std::array<WavelengthPosition, kLanes>& where) const;

 private:
    std::size_t sets_;
    int intervals_;
    std::size_t stride_;  // of a row by wavelength, whose last value is stored twice
    double min_cosine_;
    std::vector<float> ratio_;  // [set][cosine][wavelength]
    bool alike_;
};

/// FlakeFilms of these. The last few are kept, 64 MiB in all, for callers that show one paint in several
/// ways, or change its other numbers. @throws as its constructor
std::shared_ptr<const FlakeFilms> flake_films(const optics::Platelet& platelet,
                                              const optics::Material& binder,
                                              std::span<const double> wavelengths_nm,
                                              double min_cosine, SharedProgress* work = nullptr,
                                              int cosine_intervals = FlakeFilms::kCosineIntervals);

/// Thickness of the films of the set's platelets, nm: [platelet][film], core first. One platelet where
/// no film varies.
std::vector<std::vector<double>> representative_thicknesses_nm(const optics::Platelet& platelet);

inline FloatLanes BoundFlakeFilms::ratio(float cosine, std::uint32_t film) const {
    const std::uint64_t set = (film * sets_) >> 32;
    const float x =
        std::clamp((cosine - min_cosine_) * per_cosine_, 0.0f, static_cast<float>(intervals_));
    const int at = std::min(static_cast<int>(x), intervals_ - 1);
    const FloatLanes* p = ratio_.data() + set * static_cast<std::size_t>(intervals_ + 1) + at;
    return p[0] + (x - at) * (p[1] - p[0]);
}

}  // namespace nacre::bsdf
