#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/progress.h"
#include "nacre/solver/solved_paint.h"
#include "nacre/sparkle/coat_thickness.h"
#include "nacre/sparkle/coat_waves.h"

namespace nacre::bsdf {

/// Chooses the model Microflake, or tables of what it shows.
struct MicroflakeModel {
    /// In which form the BRDF of a solved paint is kept for rendering.
    enum class Table {
        split,  ///< Nacre's own: interface, single scattering in closed form, a low-rank table of
                ///< the multiple scattering; spectral
        raw,    ///< as the papers tabulate it: angles times angles, RGB    [ergun-2016; mir-2022]
        svd     ///< its truncated singular value decomposition
    };
    Table table = Table::split;
    std::uint64_t specimen = 0;            ///< which panel of the batch: the seed of its coat
    BrdfTableSettings table_size = {};     ///< raw and svd
    CompressionSettings compression = {};  ///< svd

    static const ModelInfo info;
    std::shared_ptr<const Bsdf> make(const ModelInput& input, const Progress& progress) const;
    std::string text() const;
    bool makes_table() const { return table != Table::split; }
    std::optional<BrdfTable> make_table(const solver::SolvedPaint& paint,
                                        const Progress& progress) const;
    void require_kind(const BrdfTable& read, const std::string& file) const;
    bool makes_arrays() const { return !makes_table(); }
    std::shared_ptr<NacreArrays> make_arrays(
        const std::shared_ptr<const solver::SolvedPaint>& paint, ArrayParts parts,
        const Progress& progress) const;

    friend bool operator==(const MicroflakeModel&, const MicroflakeModel&) = default;
};

/// The micro-flake model of Ergun et al. 2016 for rendering: interface + single scattering in
/// closed form + the solver's multiple scattering from a table.
///                                                                 [ergun-2016; docs/microflake.md]
///
/// Agrees with SolvedPaint::brdf to kMicroflakeError of the peak of each incident direction, for a
/// binder of index 1.3 or more, flake roughness 0.02 to 0.5 and incidence up to 89 deg. Without a
/// coat (index near 1) lobes sharpen without bound towards grazing angles, where the table of the
/// multiple scattering does not follow: up to 5 % of the peak beyond 60 deg at roughness 0.1. The
/// solved paint itself stays exact there. Wavelengths between those of the paint are interpolated
/// linearly, those beyond its ends take the end's value.
class Microflake final : public Bsdf {
 public:
    /// @param specimen  of the waves of its coat, if the recipe has an orange_peel, and of its thickness,
    ///                  if that has a spread
    /// @param progress  is asked whether to go on while a coat of uneven thickness is solved
    explicit Microflake(std::shared_ptr<const solver::SolvedPaint> paint,
                        std::uint64_t specimen = 0, const Progress& progress = {});
    ~Microflake() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    const sparkle::CoatWaves* coat_waves() const override { return waves_ ? &*waves_ : nullptr; }
    const sparkle::CoatThickness* coat_thickness() const override {
        return thickness_ ? &*thickness_ : nullptr;
    }

    std::optional<Vec2f> flake_lean() const override { return lean_; }

    struct Tables;
    const Tables& tables() const { return *tables_; }

 private:
    std::shared_ptr<const Tables> tables_;
    std::optional<sparkle::CoatWaves> waves_;
    std::optional<sparkle::CoatThickness> thickness_;
    std::optional<Vec2f> lean_;
};

inline constexpr double kMicroflakeError = 2e-3;
/// The same under a rough clearcoat, where the table holds single scattering too.
inline constexpr double kMicroflakeRoughError = 5e-3;

}  // namespace nacre::bsdf
