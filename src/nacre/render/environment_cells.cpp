#include "nacre/render/environment_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/core/parallel.h"
#include "nacre/render/direction_distribution.h"

namespace nacre::render {
namespace {

using Coefficients = EnvironmentRadiance::Coefficients;

// The coarsest cells, some 18 degrees wide, and how much finer they may get.
constexpr int kCoarseColumns = 16, kCoarseRows = 8, kMaxScale = 64;

float nominal_solid_angle(int scale) {
    return 4 * std::numbers::pi_v<float> / (kCoarseColumns * kCoarseRows * float(scale * scale));
}

/// What a cell's points add up to.
struct CellSums {
    std::array<double, 3> coefficients{};
    double luminance = 0, weight = 0;
    float brightest = 0;

    void add(const Coefficients& c, float y, double w) {
        for (int i = 0; i < 3; ++i) coefficients[i] += w * c[i];
        luminance += w * y;
        weight += w;
        brightest = std::max(brightest, y);
    }
    void add(const CellSums& other) {
        for (int i = 0; i < 3; ++i) coefficients[i] += other.coefficients[i];
        luminance += other.luminance;
        weight += other.weight;
        brightest = std::max(brightest, other.brightest);
    }
};

/// The cell of a direction, among so many across and down.
std::size_t cell_of(Vec3f direction, int wide, int high) {
    const Vec2f at = DirectionDistribution::to_square(direction);
    const int column = std::min(static_cast<int>(at.x * wide), wide - 1);
    const int row = std::min(static_cast<int>(at.y * high), high - 1);
    return static_cast<std::size_t>(row) * wide + column;
}

/// Over points in the rows and columns of a picture, two or more a pixel each way, or one of large ones: of
/// what is linear between the middles of pixels they leave nothing out, however near a pole.
std::vector<CellSums> sums_of_picture(const EnvironmentRadiance& environment, int width, int height,
                                      int scale) {
    constexpr int kLarge = 2048;
    const int wide = kCoarseColumns * scale, high = kCoarseRows * scale;
    const int columns = std::max(width > kLarge ? width : 2 * width, 2 * wide),
              rows = std::max(width > kLarge ? height : 2 * height, 2 * high);
    std::vector<CellSums> cells(static_cast<std::size_t>(wide) * high);
    std::vector<Vec2f> level;  // directions along the horizon
    for (int column = 0; column < columns; ++column) {
        const double azimuth = 2 * std::numbers::pi * (column + 0.5) / columns;
        level.push_back(
            {static_cast<float>(std::cos(azimuth)), static_cast<float>(std::sin(azimuth))});
    }
    // Points of one height lie in one row of cells, as the map keeps heights.
    std::vector<std::vector<double>> zeniths(high);
    for (int row = 0; row < rows; ++row) {
        const double zenith = std::numbers::pi * (row + 0.5) / rows;
        const Vec3f d = {static_cast<float>(std::sin(zenith)), 0,
                         static_cast<float>(std::cos(zenith))};
        zeniths[cell_of(d, wide, high) / wide].push_back(zenith);
    }
    parallel_for(0, zeniths.size(), [&](std::size_t cell_row) {
        for (const double zenith : zeniths[cell_row]) {
            const auto sine = static_cast<float>(std::sin(zenith)),
                       cosine = static_cast<float>(std::cos(zenith));
            for (const Vec2f& along : level) {
                const Vec3f d = {sine * along.x, sine * along.y, cosine};
                const Coefficients c = environment.coefficients(d);
                const std::size_t column = cell_of(d, wide, high) % wide;
                cells[cell_row * wide + column].add(c, environment.luminance_of(c), sine);
            }
        }
    });
    return cells;
}

/// Over points as dense as the environment asks for.
std::vector<CellSums> sums_of(const EnvironmentRadiance& environment, int detail, int scale) {
    const int wide = kCoarseColumns * scale, high = kCoarseRows * scale;
    const int across = (detail + wide - 1) / wide, down = across;
    std::vector<CellSums> cells(std::size_t(wide) * high);
    parallel_for(0, cells.size(), [&](std::size_t cell) {
        const int column = static_cast<int>(cell) % wide, row = static_cast<int>(cell) / wide;
        for (int i = 0; i < across * down; ++i) {
            const float u = (column + (i % across + 0.5f) / across) / wide;
            const float v = (row + (i / across + 0.5f) / down) / high;
            const Vec3f d = DirectionDistribution::from_square(Vec2f{u, v});
            // Solid angle of the point: the map keeps areas in height alone.
            const float round = std::sqrt(d.x * d.x + d.y * d.y);
            const double bend = round > 0 ? (std::abs(d.x) + std::abs(d.y)) / round : 1.0f;
            const Coefficients c = environment.coefficients(d);
            cells[cell].add(c, environment.luminance_of(c), bend * bend);
        }
    });
    return cells;
}

/// Of cells half as many across and down.
std::vector<CellSums> coarser(const std::vector<CellSums>& fine, int scale) {
    const int wide = kCoarseColumns * scale;
    std::vector<CellSums> cells(fine.size() / 4);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const int column = static_cast<int>(i) % wide, row = static_cast<int>(i) / wide;
        cells[std::size_t(row / 2) * (wide / 2) + column / 2].add(fine[i]);
    }
    return cells;
}

}  // namespace

EnvironmentCells::EnvironmentCells(const EnvironmentRadiance& environment, int detail,
                                   int picture_width, int picture_height) {
    int scale = 1;
    while (scale < kMaxScale && 4 * scale * kCoarseColumns <= detail) scale *= 2;
    for (std::vector<CellSums> sums =
             picture_width > 0 ? sums_of_picture(environment, picture_width, picture_height, scale)
                               : sums_of(environment, detail, scale);
         ; sums = coarser(sums, scale), scale /= 2) {
        Level level{scale, {}};
        level.cells.reserve(sums.size());
        for (const CellSums& s : sums) {
            Cell cell;
            for (int i = 0; i < 3; ++i) {
                cell.mean[i] = static_cast<float>(s.coefficients[i] / s.weight);
            }
            cell.has_firefly = s.brightest * s.weight > kFireflyRatio * s.luminance;
            level.cells.push_back(cell);
        }
        levels_.push_back(std::move(level));
        if (scale == 1) break;
    }
    std::reverse(levels_.begin(), levels_.end());
}

const Coefficients* EnvironmentCells::spread(Vec3f direction, float solid_angle) const {
    const Level* level = levels_.data();
    while (nominal_solid_angle(2 * level->scale) >= solid_angle) {
        if (level == &levels_.back()) return nullptr;
        ++level;
    }
    const int wide = kCoarseColumns * level->scale, high = kCoarseRows * level->scale;
    const Cell& cell = level->cells[cell_of(direction, wide, high)];
    return cell.has_firefly ? &cell.mean : nullptr;
}

}  // namespace nacre::render
