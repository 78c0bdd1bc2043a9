#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bound_microflake.h"
#include "nacre/bsdf/nacre_tables.h"

// The nacre model at eight wavelengths.

namespace nacre::bsdf {

class BoundNacre final : public BoundMicroflake {
 public:
    BoundNacre(std::shared_ptr<const Nacre::Tables> tables, const Wavelengths& wavelengths);

    // The mean over all patches: that of BoundMicroflake, but for a hot spot.
    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;

    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float u_lobe,
                                        Vec2f u) const override;
    std::size_t patch_memory_bytes() const override {
        return tables_->species.size() * sizeof(sparkle::FlakeView);
    }

 private:
    class MeanHotSpot;
    class FlakesOfPatch;

    // The flakes of a patch, by species: in its memory or, where it has none, in one of our own.
    class Look {
     public:
        Look(const BoundNacre& surface, const Patch& patch);
        const sparkle::FlakeView& operator[](std::size_t species) const { return views_[species]; }

     private:
        PatchMemory own_;
        const sparkle::FlakeView* views_;
    };

    // Odds of the ways to sample a patch, in proportion to the light that they are expected to find
    // on it; with those of single flakes they add up to 1.
    struct Odds {
        LobeOdds lobes;
        float flakes;       // all told apart
        float per_species;  // times share times weight_sum: of those of one species
    };
    Odds odds_on(const Look& look, const Ray& i) const;
    std::optional<Vec3f> draw_flake(const Look& look, const Odds& odds, const Ray& i, float u_flake,
                                    Vec2f u) const;
    // Per solid angle outside, of draw_flake().
    float flake_density(const Look& look, const Odds& odds, const Ray& i, const Ray& o) const;
    FloatLanes value_on(const Look& look, const Ray& i, const Ray& o) const;
    FloatLanes mean_value(const Ray& i, const Ray& o) const;

    std::shared_ptr<const Nacre::Tables> tables_;
    std::vector<BoundFlakeFilms> films_;  // by species
    std::optional<HotSpot> hot_spot_;
};

}  // namespace nacre::bsdf
