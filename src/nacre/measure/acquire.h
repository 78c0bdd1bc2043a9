#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/measure/instrument.h"

namespace nacre::measure {

/// Limit of the readers of these files: 2 GiB.
inline constexpr double kMaxTableBytes = 2147483648.0;

/// @param memory  that the table, its file and the copy that is compared with the BRDF take, bytes
/// @throws DomainError if a table would have more bytes than that; Error if the machine has not the
///         memory
inline void require_table_size(double bytes, double memory) {
    if (!(bytes <= kMaxTableBytes)) {
        throw DomainError(fmt::format(
            "a table of {:.3g} GB is larger than the {:.3g} GB that files of its format "
            "may have: choose fewer points or wavelengths",
            1e-9 * bytes, 1e-9 * kMaxTableBytes));
    }
    require_memory(memory, fmt::format("measuring a table of {:.2g} GB", 1e-9 * bytes),
                   "choose fewer points or wavelengths");
}

inline constexpr const char* kMeasuring = "measuring the BRDF";

/// Calls body(row, counter) for each row on all threads and reports after each. Within a row the body
/// asks counter.keep_going(), and returns early where it says so.
/// @throws Stopped if `progress` asks to stop
template <class Body>
void for_each_row(int rows, const Progress& progress, const Body& body) {
    SharedProgress counter(progress, rows);
    parallel_for(0, static_cast<std::size_t>(rows), [&](std::size_t row) {
        if (counter.stopped()) return;
        body(static_cast<int>(row), counter);
        counter.add();
    });
    counter.throw_if_stopped(kMeasuring);
}

/// Cells of a table over half and difference angles, [2, 1024] each. Reading code of the database
/// accepts the defaults only.
struct MerlSettings {
    int half = bsdf::MerlTable::kHalf;
    int difference = bsdf::MerlTable::kDifference;
    int azimuths = bsdf::MerlTable::kAzimuths;
};

/// Measures a reciprocal isotropic surface that is symmetric about the plane of incidence,
/// as every one of Nacre's is, in the middle of every cell; cells with a direction below the
/// horizon are marked as not measured, with -1. RGB is that of spectra::rec709_weights(), with
/// components outside the gamut cut off at zero, as negative values mark cells.
///                                                                        [matusik-2003]
/// @param wavelengths_nm  those of `brdf`, increasing
/// @throws DomainError if a setting is out of range, the table larger than 2 GiB, or the BRDF
/// negative or not finite somewhere
/// @throws Stopped if `progress` asks to stop
bsdf::MerlTable acquire_merl(const Brdf& brdf, const std::vector<double>& wavelengths_nm,
                             const MerlSettings& settings, const Progress& progress = {});

// A virtual goniophotometer that writes the RGL material database's files: from any BRDF to a
// table in the adaptive parameterization.                                 [dupuy-jakob-2018]

struct RglSettings {
    int resolution = 64;       ///< points of the unit square per side, [4, 512]
    int incident = 64;         ///< polar angles of incidence, [2, 256]
    int ndf_resolution = 256;  ///< polar angles of the facets' distribution, [8, 4096]
    bool rgb = false;          ///< linear Rec. 709 instead of a spectrum
};

/// Measures an isotropic surface that is symmetric about the plane of incidence, as every
/// one of Nacre's is.
///
/// The distribution of facets D follows from retroreflection, f(m, m) cos(theta_m) =
/// D(m) / (4 sigma(m)) to a factor, with sigma the projected area of D: an eigenvector, found by
/// power iteration [dupuy-jakob-2018, section 5.1]. A fiftieth of it is made uniform, so that no
/// direction is left without facets. It determines where the table is fine, not its values: at its
/// nodes the table is exact to single precision. The field `vndf`, by which a reader finds the
/// nodes, is not the visible facets but a spacing of nodes that keeps the error small
/// (docs/measured.md); `luminance` makes up for it, so that samples follow the light.
///
/// Incidences reach from 0 to kMaxIncidence, the closer the nearer to grazing: count them by k from
/// 0 to n; the k-th lies at (1 - (1 - k/n)^1.5) kMaxIncidence. RGB is that of
/// spectra::rec709_weights(), with components outside the gamut cut off at zero.
///
/// @param wavelengths_nm  those of `brdf`, increasing
/// @throws DomainError if a setting is out of range, the table larger than 2 GiB, or the BRDF
/// negative or not finite somewhere
/// @throws Stopped if `progress` asks to stop
bsdf::RglTable acquire_rgl(const std::string& description, const Brdf& brdf,
                           const std::vector<double>& wavelengths_nm, const RglSettings& settings,
                           const Progress& progress = {});

/// Largest incidence of a table, in rad (89 deg), at which larger ones are read.
inline constexpr double kMaxIncidence = 1.5533430342749532;

/// Error of a table against the BRDF that it was made of, over incidences from 5 to 80 deg.
struct TableError {
    double flux = 0;  ///< Int |f' - f| cos over Int f cos, mean over incidences and wavelengths
    /// Largest |f' - f| cos over the largest f cos of its incidence and wavelength. With the
    /// cosine, since RGL tables hold f cos, whose quotient f is uncertain near the horizon.
    double peak = 0;
};

/// Compared at eight of the wavelengths, at directions off the table's nodes: half of them sampled
/// from the table, half evenly spread over the hemisphere, which count for `peak` only.
/// @param rgb  the table holds colours: compared with the spectra of the exact ones
/// @throws DomainError as SpectrumColour
/// @throws Stopped if `progress` asks to stop
TableError table_error(const bsdf::Bsdf& table, const Brdf& exact,
                       const std::vector<double>& wavelengths_nm, bool rgb,
                       const Progress& progress = {});

}  // namespace nacre::measure
