#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/microflake_tables.h"
#include "nacre/bsdf/tabulated.h"

// What the tabulated model works out once a table, before any wavelength is chosen.

namespace nacre::bsdf {

/// One direction, and what a lookup needs of it.
struct TableRay {
    Vec3f outside, inside;  ///< inside: refracted with the mean index
    float sine;             ///< outside
    float side_cosine;      ///< on the side on which the grid measures half vectors
    float transmittance;    ///< of a smooth interface over n; 1 for a rough one
};

struct Tabulated::Tables {
    using Data = std::variant<std::shared_ptr<const layers::RawBrdfTable>,
                              std::shared_ptr<const layers::CompressedBrdfTable>>;

    explicit Tables(Data table);

    Data data;
    layers::BrdfGrid grid;
    float ior, inverse_ior;
    /// Lobes that samples come from, inside the coat; under a rough interface, its own outside.
    FlakeLobe flakes, wide;
    std::optional<FlakeLobe> interface;
    std::vector<LobeOdds> odds;       ///< by direction row
    std::vector<layers::Rgb> albedo;  ///< by direction row, the mirror left out

    TableRay make_ray(Vec3f w) const;
    /// The BRDF in linear Rec. 709.
    layers::Rgb rgb(const TableRay& i, const TableRay& o) const;
    const LobeOdds& odds_at(Vec3f wi) const;
    /// Density of sampling o given i, the mirror left out.
    float density(const LobeOdds& odds, const TableRay& i, const TableRay& o) const;
    /// Densities of the lobes apart: interface, flakes, wide, diffuse.
    std::array<float, 4> densities(const TableRay& i, const TableRay& o) const;

 private:
    float leave(const TableRay& o) const;
    void fit_row(int row);
};

/// Row of the direction tables and the fraction to the next.
struct DirectionRow {
    int row;
    float fraction;
};
DirectionRow direction_row(Vec3f w);

}  // namespace nacre::bsdf
