#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/progress.h"
#include "nacre/core/vec.h"
#include "nacre/paint/recipe.h"

// A recipe for the random walk, for one batch of at most kLanes wavelengths: the rates at which a
// ray meets flakes and pigments in each slab, and how they scatter. Everything is derived here from
// the flakes themselves, not taken from the solver (docs/reference.md). Directions are directions
// of travel, lengths in um, rates in 1/um.

namespace nacre::montecarlo {

/// A quantity per wavelength of the batch. Lanes beyond Medium::lane_count hold zeros.
using Lanes = DoubleLanes;

/// Intervals of the uniform cosine grid on which R and T of a computed platelet are tabulated;
/// between its nodes they are linear. For 150 nm of TiO2 on 500 nm of mica the interpolated R is
/// within kPlateletTableError of the transfer matrix at every cosine and wavelength of the visible.
inline constexpr int kPlateletTableIntervals = 2048;
inline constexpr double kPlateletTableError = 6e-5;

/// Reflectance and transmittance of a flake against the cosine of incidence on it.
class FlakeOptics {
 public:
    /// @throws DomainError, Stopped as optics::platelet_table()
    FlakeOptics(const paint::FlakeSpecies& species, const optics::Material& binder,
                std::span<const double> wavelengths_nm, SharedProgress* work = nullptr);
    /// From tables on the uniform cosine grid, or of one node each.
    FlakeOptics(std::vector<Lanes> reflectances, std::vector<Lanes> transmittances)
        : reflectance_(std::move(reflectances)), transmittance_(std::move(transmittances)) {}

    /// @param cosine  |w.m| in [0, 1]; rounding above 1 is taken as 1
    Lanes reflectance(double cosine) const;
    Lanes transmittance(double cosine) const;

    /// The tables: from cosine 0 to 1, or one node.
    const std::vector<Lanes>& reflectances() const { return reflectance_; }
    const std::vector<Lanes>& transmittances() const { return transmittance_; }

 private:
    std::vector<Lanes> reflectance_, transmittance_;  // one node: the same at every angle
};

/// The mean normal of flakes that lean, and the frame about it in which they lie as others do about z:
/// the shortest turn of z into it.
struct FlakeFrame {
    /// @param tangents  n_x/n_z and n_y/n_z of the mean normal n
    explicit FlakeFrame(const std::array<double, 2>& tangents);

    Vec3d to_flakes(const Vec3d& w) const { return {dot(w, s), dot(w, t), dot(w, n)}; }
    Vec3d from_flakes(const Vec3d& w) const { return w.x * s + w.y * t + w.z * n; }

    Vec3d n, s, t;
};

/// Flakes of one kind. Their normals have Gaussian slopes s with density
/// exp(-|s|^2 / alpha^2) / (pi alpha^2), in the frame of the mean normal where they lean.
struct Flakes {
    double area_density_per_um;  ///< c: candidate flakes per um of path, before projection
    double alpha;
    FlakeOptics optics;
    std::optional<FlakeFrame> lean = {};

    /// Scattered power per um of path and sr, from travel direction `in` to `out`, of unit power.
    ///
    /// A candidate has its upward normal m with density p(s(m)) / m_z^3 per solid angle; it is in
    /// the way with probability |in.m|; a mirror of normal m sends light to out = in - 2 (in.m) m,
    /// and a cone of normals dm to the cone d(out) = 4 |in.m| dm. What remains is
    /// c p(s) R / (4 m_z^3), m being along out - in. It depends on in and out through m and |in.m|
    /// alone: it is reciprocal.
    Lanes scattering(const Vec3d& in, const Vec3d& out) const;

    /// |w.n| of a direction w, w_z > 0, and the mean normal n.
    double cosine_to_mean_normal(const Vec3d& w) const;

    /// Extinction of a ray along a direction of cosine mu to the mean normal, by reflection and
    /// absorption, in 1/um: c E[(1 - T(|w.m|)) |w.m|] over the slopes, by quadrature in the two slope
    /// components. Relative error for constant T: kExtinctionRelativeError.
    Lanes extinction(double mu) const;
    /// The same along w, w_z > 0.
    Lanes extinction(const Vec3d& w) const;
};
inline constexpr double kExtinctionRelativeError = 2e-8;

/// A phase function at the wavelengths of the batch, as the table of optics::PhaseFunction: linear
/// in the cosine between its nodes.
class PhaseTable {
 public:
    /// @param density  [node] in 1/sr, which integrates to 1 in every lane in use
    explicit PhaseTable(std::vector<Lanes> density);

    const std::vector<Lanes>& density() const { return density_; }
    Lanes value(double cosine) const;
    /// The cosine beyond which, from 1 down, this fraction of the light of a lane is turned.
    double cosine(int lane, double fraction) const;

 private:
    std::vector<Lanes> density_,
        below_;  // below_: of the light turned by less than the node's angle
};

/// Particles that scatter by Henyey and Greenstein's phase function, or by a tabulated one.
struct Pigment {
    Lanes scattering_per_um;
    double anisotropy;
    std::shared_ptr<const PhaseTable> phase = {};  ///< null: Henyey and Greenstein's

    /// In 1/sr.                                                [henyey-greenstein-1941, eq. 2]
    Lanes phase_value(double cosine) const;
    /// Per sr and um of path.
    Lanes scattering(const Vec3d& in, const Vec3d& out) const;
};

inline constexpr int kExtinctionTableIntervals = 1024;
inline constexpr double kExtinctionTableError = 2e-5;

/// One homogeneous slab: the clearcoat or a layer.
struct Slab {
    double thickness_um = 0;
    std::vector<Flakes> flakes;
    std::vector<Pigment> pigments;
    Lanes absorption_per_um{};          ///< of clearcoat and pigments; flakes absorb by themselves
    Lanes pigment_scattering_per_um{};  ///< of all pigments
    double pigment_rate_per_um = 0;     ///< the largest of these lanes: a majorant
    double flake_rate_per_um = 0;       ///< of all flakes

    double candidate_rate_per_um() const { return flake_rate_per_um + pigment_rate_per_um; }
    /// Scattered power per um of path and sr of flakes and pigments.
    Lanes scattering(const Vec3d& in, const Vec3d& out) const;
    /// Total extinction along a direction w, w_z > 0. All flakes of a slab lean alike.
    Lanes extinction(const Vec3d& w) const;
    /// The same by the cosine |w.n| to the mean normal of the flakes, in [0, 1]: by quadrature, or
    /// from the table.
    Lanes extinction(double cosine) const;
    /// Makes extinction() cheap, for many directions: linear between kExtinctionTableIntervals
    /// equal steps of the cosine, which is right to kExtinctionTableError of the extinction along
    /// the mean normal.
    void tabulate_extinction();
    /// Fills in pigment_scattering_per_um and pigment_rate_per_um.
    void sum_pigments();

    std::vector<Lanes> extinction_table;  ///< empty until tabulate_extinction()
};

struct Medium {
    int lane_count = 0;
    double index = 1;         ///< of the binder
    std::vector<Slab> slabs;  ///< from the top down
    Lanes substrate_reflectance{};

    /// @param wavelengths_nm  1 to kLanes of them, at which the binder's index is the same
    /// @throws DomainError, Stopped as optics::platelet_table()
    Medium(const paint::Recipe& recipe, std::span<const double> wavelengths_nm,
           SharedProgress* work = nullptr);
};

// The same recipe at the many sets of wavelengths of a renderer: films are computed once.

/// Media of one recipe on a grid of wavelengths, between which everything in them is linear.
class MediumGrid {
 public:
    /// @param wavelengths_nm  strictly increasing, at least one
    /// @throws DomainError as paint::validate() does, or if the wavelengths do not increase
    /// @throws Stopped if `progress`, which is asked while films are computed, says so
    MediumGrid(const paint::Recipe& recipe, std::vector<double> wavelengths_nm,
               const Progress& progress = {});

    /// The medium at up to kLanes wavelengths; beyond the ends of the grid it is that of the end.
    /// Medium::index is that of the first; see index().
    Medium at(std::span<const double> wavelengths_nm) const;

    /// Index of the binder, likewise interpolated.
    double index(double wavelength_nm) const;

 private:
    struct Place;
    Place locate(double wavelength_nm) const;

    std::vector<double> wavelengths_nm_, index_;
    std::vector<Medium> media_;  // for kLanes wavelengths each, the last one perhaps for fewer
};

}  // namespace nacre::montecarlo
