#pragma once

#include <span>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/optics/thin_film.h"

// R and T of a flake as functions of the incidence cosine, at a set of wavelengths.

namespace nacre::paint {

/// Sampled twice: at Chebyshev-Lobatto points in the cosine, few enough to store, and from those
/// on a fine uniform grid, where a lookup is one linear interpolation for eight wavelengths.
/// Between the nodes of the fine grid R and T err by less than 2e-4 where a core up to 1 um thick
/// varies by 50 nm or more; without spread the fringes cost more: 7e-4 for a core of 500 nm, 1e-2
/// for one of 3 um.
class FlakeTable {
 public:
    /// R and T that do not depend on angle, one value per wavelength.
    static FlakeTable constant(std::span<const double> reflectance,
                               std::span<const double> transmittance);
    /// R and T given at `cosine_count` Chebyshev-Lobatto points on [0, 1] (chebyshev_cosines),
    /// as arrays [cosine][wavelength].
    /// @throws DomainError if sizes do not fit or a value leaves [0, 1]
    static FlakeTable from_chebyshev(int cosine_count, int wavelength_count,
                                     std::span<const double> reflectance,
                                     std::span<const double> transmittance);
    /// A platelet in a binder; raises the number of cosines, 33 at first, until R and T are
    /// resolved to 1e-6, or until it is `max_cosines`.
    /// @throws DomainError, Stopped as optics::platelet_table()
    static FlakeTable of_platelet(const optics::Platelet& platelet, const optics::Material& binder,
                                  std::span<const double> wavelengths_nm,
                                  int max_cosines = kMaxCosines, SharedProgress* work = nullptr);

    int wavelength_count() const { return wavelength_count_; }
    int cosine_count() const { return cosine_count_; }
    /// Whether nothing is transmitted at any angle and wavelength.
    bool is_opaque() const { return opaque_; }
    /// The values at the Chebyshev-Lobatto points, [cosine][wavelength]: what a file stores.
    const std::vector<double>& chebyshev_reflectance() const { return chebyshev_r_; }
    const std::vector<double>& chebyshev_transmittance() const { return chebyshev_t_; }

    /// R and T of the eight wavelengths of `block` (8 block ... 8 block + 7; lanes beyond the last
    /// wavelength repeat it). cosine in [0, 1].
    DoubleLanes reflectance(double cosine, int block) const {
        return lookup(fine_r_, cosine, block);
    }
    DoubleLanes transmittance(double cosine, int block) const {
        return lookup(fine_t_, cosine, block);
    }

    /// R and T at the cosine node/kFineIntervals of the fine grid, between whose nodes they are linear.
    DoubleLanes reflectance_at(int node, int block) const { return at(fine_r_, node, block); }
    DoubleLanes transmittance_at(int node, int block) const { return at(fine_t_, node, block); }

    /// Reflectance by wavelength at the cosine node/kFineIntervals of the fine grid (node 0 alone
    /// where nothing depends on angle).
    const double* fine_reflectance(int node) const { return fine_r_.data() + node * stride_; }

    static constexpr int kFineIntervals = 512;
    static constexpr int kMaxCosines = 513;

    friend bool operator==(const FlakeTable& a, const FlakeTable& b) {
        return a.wavelength_count_ == b.wavelength_count_ && a.cosine_count_ == b.cosine_count_ &&
               a.chebyshev_r_ == b.chebyshev_r_ && a.chebyshev_t_ == b.chebyshev_t_;
    }

 private:
    DoubleLanes at(const std::vector<double>& fine, int node, int block) const {
        return load_lanes(fine.data() + (intervals_ == 0 ? 0 : node) * stride_ + kLanes * block);
    }
    DoubleLanes lookup(const std::vector<double>& fine, double cosine, int block) const {
        const double x = cosine * intervals_;
        const int i = std::min(static_cast<int>(x), std::max(intervals_ - 1, 0));
        const double* p = fine.data() + static_cast<std::size_t>(i) * stride_ + kLanes * block;
        const DoubleLanes a = load_lanes(p);
        if (intervals_ == 0) return a;
        return a + (x - i) * (load_lanes(p + stride_) - a);
    }

    int wavelength_count_ = 0, cosine_count_ = 0;
    bool opaque_ = false;
    int intervals_ = 0;  // 0: no dependence on angle
    std::size_t stride_ = 0;
    std::vector<double> chebyshev_r_, chebyshev_t_;
    std::vector<double> fine_r_, fine_t_;
};

/// Chebyshev-Lobatto points on [0, 1], from 1 down to 0; one point gives {1}.
std::vector<double> chebyshev_cosines(int count);

/// Number of eight-wide blocks that hold `wavelength_count` wavelengths.
constexpr int block_count(int wavelength_count) { return (wavelength_count + kLanes - 1) / kLanes; }

}  // namespace nacre::paint
