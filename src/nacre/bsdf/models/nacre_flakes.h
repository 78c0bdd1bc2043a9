#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/lane_math.h"

// What the nacre model sums single scattering over, in place of MeanFlakes (bound_microflake.h).

namespace nacre::bsdf {

// The half vector inside, as the flakes see it.
struct HalfVector {
    Vec2f slope;
    float slope2, cosine;   // cosine: w_i . h
    float per_solid_angle;  // area of slopes per solid angle of w_o
    float spread2;          // by a rough clearcoat

    HalfVector(const Ray& i, const Ray& o, const sparkle::CoatTilt& coat)
        : spread2(coat.spread2(i.inside.z, o.inside.z)) {
        const Vec3f sum = i.inside + o.inside;
        const float inverse = 1 / sum.z;
        slope = {sum.x * inverse, sum.y * inverse};
        slope2 = slope.x * slope.x + slope.y * slope.y;
        const float sec2 = 1 + slope2;
        cosine = std::min(1.0f, 0.5f * sum.z * std::sqrt(sec2));
        // sec^3 / (4 w_i.h): area of slopes per solid angle of h over solid angle of w_o per that.
        per_solid_angle = 0.5f * inverse * sec2;
    }
};

// 1 / mean_attenuation(depth): takes that factor of single scattering out again.
inline FloatLanes inverse_mean_attenuation(const FloatLanes& depth) {
    const FloatLanes safe = max_lanes(depth, splat(1e-20f));
    return safe / one_minus_exp_lanes(safe);
}

// In place of MeanFlakes: the mean of all flakes, with the hot spot if there is one.
class BoundNacre::WithHotSpot {
 public:
    WithHotSpot(const BoundNacre& surface, const Ray& i, const Ray& o) {
        if (surface.hot_spot_) pair_.emplace(*surface.hot_spot_, i, o);
    }
    FloatLanes factor(std::size_t layer, std::size_t /*flake*/, const FloatLanes& depth) const {
        return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
    }
    FloatLanes pigment_factor(std::size_t layer, const FloatLanes& depth) const {
        return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
    }
    FloatLanes multiple(const FloatLanes& multiple) const {
        return pair_ ? pair_->multiple(multiple) : multiple;
    }
    FloatLanes multiple(const FloatLanes& multiple, const FloatLanes& compensation) const {
        return pair_ ? pair_->multiple(multiple, compensation) : multiple;
    }
    FloatLanes compensation() const { return pair_ ? pair_->compensation() : splat(1.0f); }
    FloatLanes internal_reflection_gain() const {
        return pair_ ? pair_->internal_reflection_gain() : splat(1.0f);
    }
    // What the table of single scattering under a rough clearcoat holds.
    const WithHotSpot& mean() const { return *this; }

 protected:
    std::optional<HotSpot::Pair> pair_;
};

// In place of MeanFlakes: those of a patch.
class BoundNacre::FlakesOfPatch : public WithHotSpot {
 public:
    FlakesOfPatch(const BoundNacre& surface, const PatchFlakes& views, const Ray& i, const Ray& o)
        : WithHotSpot(surface, i, o),
          surface_(surface),
          views_(views),
          half_(i, o, surface.coat()) {}

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        if (!lobe.reaches(half_.slope2)) return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
        const sparkle::FlakeView& view = views_[at];
        FloatLanes reflected{};
        bool any = false;
        const float background = view.for_each_reflecting_flake(
            lobe, half_.slope, half_.cosine,
            [&](int k, float fraction) {
                any = true;
                reflected +=
                    fraction * surface_.relative_attenuation(at, layer, view, k, half_.cosine,
                                                             depth, pair_ ? &*pair_ : nullptr);
            },
            half_.spread2);
        FloatLanes sum = splat(background);
        if (pair_ && background > 0) sum *= pair_->mean(layer, depth);
        if (any) sum += reflected * inverse_mean_attenuation(depth);
        return sum;
    }

 private:
    const BoundNacre& surface_;
    const PatchFlakes& views_;
    HalfVector half_;
};

// In place of MeanFlakes: the background, without the flakes that are sampled one by one.
class BoundNacre::BackgroundFlakes : public WithHotSpot {
 public:
    BackgroundFlakes(const BoundNacre& surface, const PatchFlakes& views, const Ray& i,
                     const Ray& o)
        : WithHotSpot(surface, i, o),
          surface_(surface),
          views_(views),
          half_(i, o, surface.coat()) {}

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        const float background =
            lobe.reaches(half_.slope2)
                ? views_[at].background_at(lobe, half_.slope2, half_.cosine, half_.spread2)
                : 1.0f;
        return pair_ && background > 0 ? background * pair_->mean(layer, depth) : splat(background);
    }

 private:
    const BoundNacre& surface_;
    const PatchFlakes& views_;
    HalfVector half_;
};

// In place of MeanFlakes: flakes of one species of a patch, and nothing else.
class BoundNacre::SomeFlakes : public WithHotSpot {
 public:
    static constexpr bool kFlakesAlone = true;

    SomeFlakes(const BoundNacre& surface, std::size_t species, const sparkle::FlakeView& view,
               const Ray& i, const Ray& o)
        : WithHotSpot(surface, i, o),
          surface_(surface),
          species_(species),
          view_(view),
          cosine_(HalfVector(i, o, surface.coat()).cosine) {}
    /// @param fraction  of the mean of the species
    void add(int flake, float fraction) {
        if (count_ == static_cast<int>(reflecting_.size())) return;
        reflecting_[count_++] = {flake, fraction};
    }
    bool empty() const { return count_ == 0; }

    bool reflects(std::size_t layer, std::size_t flake) const {
        return surface_.tables_->first_species[layer] + flake == species_;
    }
    FloatLanes factor(std::size_t layer, std::size_t, const FloatLanes& depth) const {
        FloatLanes sum{};
        for (int n = 0; n < count_; ++n) {
            sum += reflecting_[n].fraction *
                   surface_.relative_attenuation(species_, layer, view_, reflecting_[n].flake,
                                                 cosine_, depth, pair_ ? &*pair_ : nullptr);
        }
        return sum * inverse_mean_attenuation(depth);
    }

 private:
    struct Reflecting {
        int flake;
        float fraction;
    };
    const BoundNacre& surface_;
    std::size_t species_;
    const sparkle::FlakeView& view_;
    float cosine_;
    std::array<Reflecting, sparkle::FlakeView::kMax> reflecting_;
    int count_ = 0;
};

// In place of MeanFlakes: all flakes of one species, and nothing else.
class BoundNacre::AllOfSpecies : public WithHotSpot {
 public:
    static constexpr bool kFlakesAlone = true;

    /// @param bare  with nothing in their layer above them
    AllOfSpecies(const BoundNacre& surface, std::size_t species, const Ray& i, const Ray& o,
                 bool bare)
        : WithHotSpot(surface, i, o), surface_(surface), species_(species), bare_(bare) {}

    bool reflects(std::size_t layer, std::size_t flake) const {
        return surface_.tables_->first_species[layer] + flake == species_;
    }
    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        return bare_ ? inverse_mean_attenuation(depth) : WithHotSpot::factor(layer, flake, depth);
    }

 private:
    const BoundNacre& surface_;
    std::size_t species_;
    bool bare_;
};

}  // namespace nacre::bsdf
