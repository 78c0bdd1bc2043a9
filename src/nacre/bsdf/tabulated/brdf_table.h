#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/progress.h"
#include "nacre/core/vec.h"
#include "nacre/solver/rough_interface.h"
#include "nacre/solver/solved_paint.h"
#include "nacre/solver/wavelength_groups.h"
#include "nacre/spectra/rgb.h"

// Where a tabulated BRDF has its nodes, and how it is interpolated between them.
//
// A table holds, for n polar angles of either direction and m azimuths, the BRDF in linear Rec. 709
// under D65 without the factor of the interface,
//
//     f = g t_i t_o / (ior^2 (mu_i + mu_o)),
//
// t the Fresnel transmittances of a smooth interface, mu the cosines inside the coat. What is
// tabulated is g, which stays finite at grazing angles. Under a rough interface, whose lobe is part
// of the table, f = g / (mu_i + mu_o) with the cosines outside.
//
// Polar nodes are even in x = tan(theta/2), theta outside the coat: denser towards the horizon.
// Azimuthal nodes follow the half vector h inside the coat, because the lobe of the flakes is a
// function of its angle: for two polar angles
//
//     tan^2 theta_h = t^2 + b v^2,   v = sin(phi'/2),   b = 4 s_i s_o / (mu_i + mu_o)^2,
//
// with phi' the azimuth from the mirror side and s the sines inside (a rough interface: outside);
// the nodes are even in
//
//     u = sqrt(ln(1 + b v^2/a^2) / ln(1 + b/a^2)) in [0, 1],   a = lobe_alpha:
//
// dense within the lobe, sparse outside, and the same part of the lobe at the same u whatever the
// polar angles. That makes the table nearly a sum of few products, hence easy to compress.

namespace nacre::bsdf {

/// Four nodes of either polar angle pair and four azimuths, and their weights: bilinear in x,
/// cubic in u (the polynomial through the four azimuths nearest to u).
struct BrdfCell {
    std::array<std::size_t, 4> pair;  ///< i * angles + o
    std::array<float, 4> pair_weight;
    int azimuth = 0;  ///< the first of four
    std::array<float, 4> azimuth_weight;
};

struct BrdfGrid {
    int angles = 256;         ///< n, 8 to kMaxAngles
    int azimuths = 128;       ///< m, 8 to kMaxAzimuths
    double ior = 1.5;         ///< mean index of the binder over the paint's wavelengths, [1, 3]
    double roughness = 0;     ///< Beckmann alpha of the interface, [0, 1]; 0: smooth
    double lobe_alpha = 0.1;  ///< a, the roughness of the narrowest lobe, [1e-4, 1]

    static constexpr int kMaxAngles = 512, kMaxAzimuths = 512;

    /// Index of the side on which angles of half vectors are measured: inside the coat, but
    /// outside of a rough one, whose own lobe is the narrowest there.
    double side_ior() const { return roughness > 0 ? 1.0 : ior; }
    std::size_t pairs() const { return static_cast<std::size_t>(angles) * angles; }
    std::size_t values() const { return pairs() * azimuths; }

    /// theta of a polar node outside the coat, rad; just short of the horizon at the last.
    double angle(int node) const;
    /// phi_o - phi_i in [0, pi] of an azimuthal node between two polar angles; pi at node 0.
    double azimuth(double theta_i, double theta_o, int node) const;
    /// f / g between two polar angles.
    double factor(double theta_i, double theta_o) const;

    friend bool operator==(const BrdfGrid&, const BrdfGrid&) = default;
};

/// @throws DomainError if a number is out of the range given above
void validate(const BrdfGrid& grid);

/// Where both directions graze, cosines count as if their sum were at least this: there are no
/// nodes beyond.
inline constexpr float kMinCosines = 1e-5f;

/// Where two directions in the upper hemisphere fall: s their sines outside, mu their cosines on
/// the side of grid.side_ior().
inline BrdfCell locate(const BrdfGrid& grid, Vec3f wi, Vec3f wo, float s_i, float s_o, float mu_i,
                       float mu_o) {
    BrdfCell cell;
    const int n = grid.angles;
    const float gi = std::min(s_i / (1 + wi.z), 1.0f) * (n - 1);
    const float go = std::min(s_o / (1 + wo.z), 1.0f) * (n - 1);
    const int i = std::min(static_cast<int>(gi), n - 2), o = std::min(static_cast<int>(go), n - 2);
    const float fi = gi - i, fo = go - o;
    const std::size_t corner = static_cast<std::size_t>(i) * n + o;
    cell.pair = {corner, corner + 1, corner + n, corner + n + 1};
    cell.pair_weight = {(1 - fi) * (1 - fo), (1 - fi) * fo, fi * (1 - fo), fi * fo};

    // s_i s_o v^2 = |s_i wo + s_o wi|^2/(4 s_i s_o), without cancellation near the mirror side.
    const float product = s_i * s_o, square = 4 * product * product;
    const float ux = s_i * wo.x + s_o * wi.x, uy = s_i * wo.y + s_o * wi.y;
    const float v2 = square > 0 ? std::min((ux * ux + uy * uy) / square, 1.0f) : 0.0f;
    const float ior = static_cast<float>(grid.side_ior());
    const float alpha = static_cast<float>(grid.lobe_alpha);
    const float scale = ior * alpha * std::max(mu_i + mu_o, kMinCosines);
    const float ratio = 4 * product / (scale * scale);  // b/a^2
    // Near the normal nothing depends on azimuth, and the quotient of logarithms tends to v^2.
    const float u2 = ratio > 1e-4f ? std::log1p(ratio * v2) / std::log1p(ratio) : v2;
    const int m = grid.azimuths;
    const float g = std::sqrt(std::min(u2, 1.0f)) * (m - 1);
    cell.azimuth = std::clamp(static_cast<int>(g) - 1, 0, m - 4);
    const float t = g - cell.azimuth, t1 = t - 1, t2 = t - 2, t3 = t - 3;
    cell.azimuth_weight = {-t1 * t2 * t3 * (1.0f / 6), t * t2 * t3 * 0.5f, -t * t1 * t3 * 0.5f,
                           t * t1 * t2 * (1.0f / 6)};
    return cell;
}

// solver::SolvedPaint::brdf on the nodes of a grid, in RGB, fast: what depends on wavelength alone,
// or on one direction, is worked out once, and spectra become colours before they are summed over
// azimuthal orders.

class BrdfTableRows {
 public:
    /// Keeps references to both.
    BrdfTableRows(const solver::SolvedPaint& paint, const BrdfGrid& grid);

    /// One incident node, and room to work in.
    struct Workspace {
        int i;
        double theta_i;
        std::vector<solver::MultipleScatteringSlice> slices;  // one per tensor
        std::vector<double> azimuth, term;
        std::vector<Vec3d> by_order, rgb;
    };
    Workspace make_workspace(int i) const;

    /// g of the incident node and one outgoing node: `out` holds [azimuth][channel].
    void evaluate(Workspace& work, int o, float* out) const;
    /// The same at the azimuths phi_o - phi_i that stand in work.azimuth, as many as the grid has.
    void evaluate_at_azimuths(Workspace& work, int o, float* out) const;

 private:
    // Wavelengths at which the binder has one index, and the paint differs.
    struct Group {
        double ior;
        solver::PaintMedium medium;
        /// Weights of the wavelengths for red, green, blue, and zero for lanes beyond the last:
        /// [block].
        std::vector<std::array<DoubleLanes, 3>> weights;
        Vec3d white{};  ///< their sum
        /// Colours of the elements of the tensors' spectral bases: [tensor][k].
        std::vector<std::vector<Vec3d>> basis;
        /// Extinction: [layer][node][block].
        std::vector<std::vector<DoubleLanes>> extinction;
        std::shared_ptr<const solver::RoughInterface> interface;
        std::vector<double> masked;  ///< by node, under a rough interface
    };

    Group make_group(const solver::WavelengthGroup& wavelengths,
                     const std::vector<Vec3d>& weights) const;
    double scale(const Group& group, double theta_i, double theta_o) const;
    void add_tensors(Workspace& work, double theta_o) const;
    void add_single(const Group& group, double scale, Workspace& work, int o) const;
    void add_interface(const Group& group, double scale, Workspace& work, int o) const;

    const solver::SolvedPaint& paint_;
    const BrdfGrid& grid_;
    std::vector<const solver::MultipleScattering*> tensors_;
    std::vector<Group> groups_;
};

// The BRDF of a solved paint as one big table of RGB values, which compression.h turns into its
// singular value decomposition: the two representations that Mir et al. 2022 compare [mir-2022].
// The sizes are the paper's; the nodes are Nacre's own (BrdfGrid, docs/tables.md).

/// Every value: n^2 m of them per channel, 96 MiB for n = 256 and m = 128.
struct RawBrdfTable {
    std::string paint;  ///< name of the recipe
    BrdfGrid grid;
    std::vector<float> values;  ///< g in 1/sr, [i][o][azimuth][channel]

    std::size_t bytes() const { return values.size() * sizeof(float); }

    spectra::Rgb interpolate(const BrdfCell& cell) const {
        spectra::Rgb g;
        for (int corner = 0; corner < 4; ++corner) {
            const float* at =
                values.data() + 3 * (cell.pair[corner] * grid.azimuths + cell.azimuth);
            for (int tap = 0; tap < 4; ++tap) {
                const float weight = cell.pair_weight[corner] * cell.azimuth_weight[tap];
                for (int c = 0; c < 3; ++c) g[c] += weight * at[3 * tap + c];
            }
        }
        return g;
    }

    friend bool operator==(const RawBrdfTable&, const RawBrdfTable&) = default;
};

struct BrdfTableSettings {
    int angles = 256;    ///< n, as BrdfGrid::angles
    int azimuths = 128;  ///< m, as BrdfGrid::azimuths

    friend bool operator==(const BrdfTableSettings&, const BrdfTableSettings&) = default;
};

/// The grid of a paint's tables: the mean index of its binder, its narrowest lobe.
/// @throws as make_raw_table()
BrdfGrid make_grid(const solver::SolvedPaint& paint, const BrdfTableSettings& settings);

/// Tabulates solver::SolvedPaint::brdf (the total) at all nodes: the spectrum at the paint's
/// wavelengths becomes linear Rec. 709 under D65 by spectra::rec709_weights. At a node f equals the
/// colour of the solved spectrum to kRawNodeError of the peak of its two directions; between nodes
/// it is interpolated (bsdf/tabulated/tabulated.h states the error). A colour outside the gamut of
/// Rec. 709 has negative components, and keeps them.
///
/// Takes seconds and, beside the table, little memory. `progress` returning false ends it.
/// @throws DomainError if a setting is out of range; Stopped by `progress`; Error if the interface
///         is rough at some wavelengths only
RawBrdfTable make_raw_table(const solver::SolvedPaint& paint,
                            const BrdfTableSettings& settings = {}, const Progress& progress = {});

inline constexpr double kRawNodeError = 1e-5;

}  // namespace nacre::bsdf
