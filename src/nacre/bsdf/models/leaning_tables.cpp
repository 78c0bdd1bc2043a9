#include "nacre/bsdf/models/leaning_tables.h"

#include <algorithm>
#include <utility>

#include "nacre/bsdf/models/paint_table.h"
#include "nacre/core/parallel.h"
#include "nacre/solver/solver.h"

namespace nacre::bsdf {
namespace {

/// Cosine that stands for 0, along which light crosses nothing.
constexpr double kGrazing = 1e-3;

}  // namespace

LeaningTables::Part::Part(solver::SolvedPaint solved)
    : paint(std::move(solved)), table(smooth_table(paint)) {}

LeaningTables::LeaningTables(const solver::SolvedPaint& paint, SharedProgress& work)
    : over_black([&]() -> std::optional<Part> {
          if (solver::without_ground(paint.medium) == paint.medium) return std::nullopt;
          return Part(
              solver::solve_without_ground(paint, [&](double) { return work.keep_going(); }));
      }()),
      no_internal_reflection(solver::solve_without_internal_reflection(
          over_black ? over_black->paint : paint, [&](double) { return work.keep_going(); })) {
    tabulate_depths(no_internal_reflection.paint.medium);
}

void LeaningTables::tabulate_depths(const solver::PaintMedium& medium) {
    const int count = medium.wavelength_count(), blocks = paint::block_count(count);
    const auto size = static_cast<std::size_t>(kCosineIntervals + 1) * count;
    flake_extinction.assign(size, 0);
    flake_scattering.assign(size, 0);
    pigment_extinction.assign(count, 0);
    pigment_absorption.assign(count, 0);
    for (const solver::LayerMedium& layer : medium.layers) {
        const auto thickness_um = static_cast<float>(layer.thickness_um);
        for (const solver::PigmentMedium& pigment : layer.pigments) {
            for (int w = 0; w < count; ++w) {
                const auto absorbed = static_cast<float>(pigment.absorption_per_um[w]);
                const auto scattered = static_cast<float>(pigment.scattering_per_um[w]);
                pigment_extinction[w] += thickness_um * (scattered + absorbed);
                pigment_absorption[w] += thickness_um * absorbed;
            }
        }
        const solver::LayerMedium alone{layer.thickness_um, layer.flakes, {}};
        parallel_for(0, kCosineIntervals + 1, [&](std::size_t k) {
            const double mu = std::max(static_cast<double>(k) / kCosineIntervals, kGrazing);
            const solver::Losses losses = solver::losses(alone, mu, 0, blocks);
            for (int w = 0; w < count; ++w) {
                const double met = losses.extinction[w / kLanes][w % kLanes];
                const double absorbed = losses.absorption[w / kLanes][w % kLanes];
                flake_extinction[k * count + w] += thickness_um * static_cast<float>(met);
                flake_scattering[k * count + w] +=
                    thickness_um * static_cast<float>(std::max(met - absorbed, 0.0));
            }
        });
    }
}

BoundLeaningTables::BoundLeaningTables(const LeaningTables& tables,
                                       const std::array<WavelengthPosition, kLanes>& where)
    : no_internal_reflection(bind_table(tables.no_internal_reflection.table,
                                        tables.no_internal_reflection.paint, where)) {
    if (tables.over_black) {
        over_black = bind_table(tables.over_black->table, tables.over_black->paint, where);
    }
    const int count = tables.no_internal_reflection.paint.medium.wavelength_count();
    const auto bound = [&](const std::vector<float>& table, int row) {
        return at_wavelengths(where, [&](int w) { return table[row * count + w]; });
    };
    for (int k = 0; k <= LeaningTables::kCosineIntervals; ++k) {
        flake_extinction_.push_back(bound(tables.flake_extinction, k));
        flake_scattering_.push_back(bound(tables.flake_scattering, k));
    }
    pigment_extinction_ = bound(tables.pigment_extinction, 0);
    pigment_absorption_ = bound(tables.pigment_absorption, 0);
}

OpticalDepths BoundLeaningTables::depths(float cosine) const {
    const float at = cosine * LeaningTables::kCosineIntervals;
    const int row = std::clamp(static_cast<int>(at), 0, LeaningTables::kCosineIntervals - 1);
    const auto look_up = [&](const std::vector<FloatLanes>& table) {
        return table[row] + (at - row) * (table[row + 1] - table[row]);
    };
    return {look_up(flake_extinction_), look_up(flake_scattering_), pigment_extinction_,
            pigment_absorption_};
}

}  // namespace nacre::bsdf
