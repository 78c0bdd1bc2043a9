#pragma once

#include <memory>
#include <string>

#include "nacre/bsdf/model.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::study {

/// The solved BRDF rendered from a table as the paper stores it (bsdf::FourierBrdfTable). Only for
/// the comparison: no command offers it, and no file holds it.
struct FourierTableModel {
    bsdf::BrdfTableSettings table_size = {};
    int rank = 0;  ///< r of the compression; 0: not compressed

    static const bsdf::ModelInfo info;
    std::shared_ptr<const bsdf::Bsdf> make(const bsdf::ModelInput& input,
                                           const Progress& progress) const;
    std::string text() const;

    friend bool operator==(const FourierTableModel&, const FourierTableModel&) = default;
};

/// How far a surface is from the colour of a solved paint, at directions that are no nodes.
struct TableError {
    double worst = 0;  ///< largest difference over the peak of its incident direction
    double rms = 0;    ///< root of the mean square of the same
};
TableError table_error(const bsdf::Bsdf& surface, const solver::SolvedPaint& paint);

struct MirContext;
/// Sizes, errors and times of the paper's way to store a table and of Nacre's.
void add_storage(MirContext& context);

}  // namespace nacre::study
