#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "nacre/paint/flake_sizes.h"
#include "nacre/sparkle/flake_plane.h"
#include "nacre/sparkle/flake_view.h"
#include "nacre/sparkle/footprint.h"
#include "nacre/sparkle/patch_outline.h"

namespace nacre::sparkle {

/// Flakes of one kind in one layer of a paint, as statistics.
struct FlakePopulation {
    double density_per_mm2 = 0;     ///< nu, flakes per area of the surface: c H / mean area
    double diameter_um = 20;        ///< mean
    double diameter_spread_um = 0;  ///< standard deviation (paint/flake_sizes.h)
    double alpha = 0.1;             ///< Beckmann roughness: slopes of variance alpha^2 / 2
    double ior = 1.5;               ///< of the binder, for diffraction
    double coat_roughness = 0;      ///< Beckmann alpha of the clearcoat
    double waviness = 0;            ///< alpha_w of the slopes of a flake's surface about its plane
    std::optional<paint::FlakeSizes> sizes = {};  ///< in place of both; diameter_um is typical then
};

/// The flakes of one population on a shape: any number, none of them stored, and always the same.
///
/// A Poisson process over place, slope, size, depth and film. Each flake is a hash of the cell in
/// which it lies. Cells tile three planes, those of the axes of the shape's object space, and a
/// patch looks through the surface at the plane that it faces; where it faces two or three about
/// equally, each gives a fraction of the flakes, so that there is neither seam nor stretch anywhere
/// on any shape (flake_plane.h). Flakes are divided among levels of density falling by 16: a patch
/// resolves the flakes of those levels that have few on it, scaled up to the mean of all flakes
/// (FlakeView). Cost is bounded for any patch and any density, and memory does not depend on
/// either.                                                            [docs/nacre-model.md]
class FlakeField {
 public:
    /// Of the cell (u, v) on a side of object space (Projection::side), from which its flakes are made.
    /// @param level  key of the level
    static std::uint64_t cell_key(std::uint64_t level, int side, std::int64_t u, std::int64_t v);
    /// 64 bits in two halves, of the flake number n of a cell; or of eight flakes.
    template <class Bits>
    struct FlakeBits {
        Bits place, kind;
    };
    template <class Bits>
    static FlakeBits<Bits> flake_bits(std::uint64_t cell, Bits n) {
        constexpr std::uint32_t kShortGolden = 0x9e3779b9u;
        const Bits step = (n + 1u) * kShortGolden;
        return {mix_bits_32(static_cast<std::uint32_t>(cell) + step),
                mix_bits_32(static_cast<std::uint32_t>(cell >> 32) + step)};
    }

    /// @throws DomainError naming the argument, its value and its range
    FlakeField(const FlakePopulation& population, std::uint64_t seed);

    /// How the flakes that a patch resolves stand for more of them.
    ///
    /// Wider lobes let as many of them reflect light from one direction as of all flakes, with the
    /// right distribution; but the wider the light, the more they would vary. Lower contrast alone
    /// is right in mean and variance for light of any width, but few flakes flash in that of a
    /// narrow lamp.
    struct StandIns {
        /// Area of slopes that a light fills, over that of the lobe of a typical flake: up to 1
        /// lobes are widened as for light from one direction, and the contrast is that of this
        /// light; above, the contrast alone is lowered.
        float light_area = 0;
    };
    /// Replaces `view` by what the patch shows.
    void query(const ObjectSpaceFootprint& patch, FlakeView& view, const StandIns& stand_ins) const;
    void query(const ObjectSpaceFootprint& patch, FlakeView& view) const { query(patch, view, {}); }
    /// As query(), but the view lists no flakes: its background, at a fraction of the cost.
    void leave_out(const ObjectSpaceFootprint& patch, FlakeView& view,
                   const StandIns& stand_ins) const;
    /// Area of slopes, for a typical flake that mirrors the direction of this cosine inside upwards,
    /// over which the square of its lobe has the integral that it would have if even: 1 / Int K^2.
    float lobe_area(float cosine) const;

    /// Side of the largest square, on a flat surface across an axis of the object space, that
    /// resolves every flake: FlakeView::widening is 1 and nothing is approximated. 0 if so many
    /// flakes lie over each other that not even a point does.
    double exact_side_mm() const;

    /// What query() works with, for programs that do it themselves, such as shaders.
    struct Constants {
        static constexpr int kLevels = 5;
        static constexpr int kSideBits = 2;  ///< the sides of the cells double as often from level
                                             ///< to level
        static constexpr int kMaxFlakesPerCell = 24;
        /// The finest levels are used up to this many times full_cells, as looking at one flake is
        /// cheap: real flakes are shown where a coarser level would show as many substitutes. Each
        /// level has faded out before the next starts to.
        static constexpr std::array<float, 2> kFinestCells{40, 12};
        std::array<double, kLevels> cell_mm;              ///< side of the cells, by level
        std::array<std::uint64_t, kLevels> key;           ///< of their hashes
        std::array<float, kLevels> fraction;              ///< rho_l, of all flakes
        std::array<float, kMaxFlakesPerCell> cumulative;  ///< probability of at most n in a cell
        std::array<float, kLevels>
            full_cells;        ///< a level begins to fade where a patch touches so many cells
        float inverse_cover;   ///< 1 / (density x mean area)
        float typical_radius;  ///< FlakeView::typical_radius
        float max_widening;    ///< of FlakeView::widening
    };
    Constants constants() const;

    const FlakePopulation& population() const { return population_; }
    const DiffractionLobe& lobe() const { return lobe_; }
    const paint::FlakeSizes& sizes() const { return sizes_; }

 private:
    static constexpr int kLevels = Constants::kLevels, kSideBits = Constants::kSideBits;
    // Of densities; the sides of the cells grow by its root.
    static constexpr int kLevelRatio = 1 << (2 * kSideBits);
    struct Level {
        double cell_mm;  // side of its cells
        std::uint64_t key;
    };
    // Weights of the levels on a patch.
    struct Weights {
        FloatLanes by_level{};
        float resolved = 0;  // sum of weight times fraction
        float widening = 1;  // FlakeView::widening
    };
    struct Cell {
        std::int64_t u, v;
        int level;
    };
    // Flakes that may touch a patch.
    struct Found {
        FlakeView::List<std::uint32_t> place, kind;
        FlakeView::List<float> corner_u, corner_v, grain, weight;  // of their cells, in mm
        int count = 0;
    };

    /// @param side_mm  the two of the patch
    Weights level_weights(const float* side_mm, const StandIns& stand_ins) const;
    /// A view that lists no flakes yet.
    Weights begin(const float* side_mm, const StandIns& stand_ins, FlakeView& view) const;
    void find(const FlakePlane& plane, const Weights& weights, Found& found) const;
    void find_in_cell(const Cell& cell, const FlakePlane& plane, const Weights& weights,
                      Found& found) const;
    void show(const Found& found, const FlakePlane& plane, const PatchOutline& outline,
              float widening, FlakeView& view) const;

    /// Flakes that a cell generates on average; kMaxStretch times fewer where one side serves.
    static constexpr double kFlakesPerCell = 4;
    static constexpr int kMaxFlakesPerCell = Constants::kMaxFlakesPerCell;

    FlakePopulation population_;
    paint::FlakeSizes sizes_;
    DiffractionLobe lobe_;
    std::array<Level, kLevels> levels_;
    // By level; 0 in the lanes beyond the last.
    FloatLanes per_mm_{}, fraction_{};  // 1 / side of the cells; of all flakes
    /// [n]: the probability of at most n flakes in a cell.
    std::array<float, kMaxFlakesPerCell> cumulative_;
    /// A level begins to fade out where the patch touches this many of its cells.
    FloatLanes full_cells_;
    float alpha_, largest_radius_mm_, smallest_radius_mm_;
    float inverse_cover_;   // 1 / (density x mean area)
    float typical_radius_;  // FlakeView::typical_radius
    float max_widening_;    // of a typical lobe, which must stay narrow against the slopes
};

}  // namespace nacre::sparkle
