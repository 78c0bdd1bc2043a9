#pragma once

#include <variant>
#include <vector>

#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/vec.h"

// A tabulated BRDF as Mir et al. 2022 store theirs: Fourier coefficients in azimuth of what remains
// when the flakes' reflectance R has been divided out, which is multiplied again while rendering
// [mir-2022; docs/tables.md]. Beside it stands Nacre's own form, values at azimuths that follow the
// lobe (brdf_table.h).

namespace nacre::bsdf {

/// g = R(cos theta_d) sum_l a_l cos(l phi), l = 0 ... m - 1, with g and the polar nodes as in
/// RawBrdfTable, phi = phi_o - phi_i and theta_d the angle between w_i and the half vector inside.
///
/// R is the mean over all flakes of the paint, by area, of each channel in linear Rec. 709. A
/// channel whose R falls below kMinDivisor anywhere is not divided: its R is 1.
struct FourierBrdfTable {
    BrdfGrid grid;  ///< azimuths: the number of orders, m
    /// R at the cosines k / kReflectanceIntervals, between which it is linear.
    std::vector<spectra::Rgb> reflectance;
    /// Laid out as the values of BRDF tables, the order in the place of the azimuth.
    std::variant<RawBrdfTable, CompressedBrdfTable> coefficients;

    static constexpr int kReflectanceIntervals = 64;
    static constexpr double kMinDivisor = 0.02;

    /// Of coefficients and reflectance.
    std::size_t bytes() const;
    /// @param cell  of which the pairs of polar nodes count
    /// @param cos_phi, cos_d  as above, in [-1, 1] and [0, 1]
    spectra::Rgb interpolate(const BrdfCell& cell, float cos_phi, float cos_d) const;
};

/// Tabulates solver::SolvedPaint::brdf: 2 m samples of azimuth a pair of polar nodes, in the middle
/// of equal steps over 180 deg, so that orders below m are free of aliasing from those below 3 m.
/// @param settings  azimuths: m, at most BrdfGrid::kMaxAzimuths / 2
/// @throws as make_raw_table()
FourierBrdfTable make_fourier_table(const solver::SolvedPaint& paint,
                                    const BrdfTableSettings& settings = {},
                                    const Progress& progress = {});

/// Its truncated singular value decomposition, by compress().
/// @throws DomainError as compress(), if the table is compressed already, or if
///         settings.clip_to_gamut is set: coefficients below zero are no colours
FourierBrdfTable compress(const FourierBrdfTable& table, const CompressionSettings& settings);

}  // namespace nacre::bsdf
