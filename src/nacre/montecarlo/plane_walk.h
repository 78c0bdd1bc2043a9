#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/interface.h"
#include "nacre/montecarlo/medium.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::montecarlo {

/// Chooses the model PlaneWalk.
struct WalkModel {
    static const bsdf::ModelInfo info;
    std::shared_ptr<const bsdf::Bsdf> make(const bsdf::ModelInput& input,
                                           const Progress& progress) const;
    std::string text() const { return {}; }  // nothing to choose

    friend bool operator==(const WalkModel&, const WalkModel&) = default;
};

/// What walks through one paint share, before any wavelength is chosen.
struct WalkTables {
    paint::Recipe recipe;
    MediumGrid grid;

    WalkTables(const paint::Recipe& r, const std::vector<double>& wavelengths_nm,
               const Progress& progress)
        : recipe(r), grid(r, wavelengths_nm, progress) {}
};

// What PlaneWalk, ShellWalk and DiscWalk share: the random choice between specular reflection and
// entry, and the samples that a renderer gets.

/// Light that has just come in at the origin of the local frame.
struct Entry {
    Vec3d travel;  ///< inside, z < 0
    Lanes weight{};
    int lane = 0;                        ///< whose index of refraction holds
    const bsdf::Patch* patch = nullptr;  ///< where, if known
};

/// Light that has just left.
struct Escape {
    Vec3d direction;
    Vec3d position_um{0, 0, 0};  ///< from where it came in
    Lanes weight{};
};

class BoundWalk : public bsdf::BoundBsdf {
 public:
    FloatLanes eval(Vec3f, Vec3f) const override { return FloatLanes{}; }
    float pdf(Vec3f, Vec3f) const override { return 0; }
    std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        return walk(nullptr, wi, u_select, u);
    }
    std::optional<bsdf::BsdfSample> sample_on(const bsdf::Patch& patch, Vec3f wi, float u_select,
                                              Vec2f u) const override {
        return walk(&patch, wi, u_select, u);
    }
    /// Linear between kAlbedoIntervals + 1 directions, each of which is estimated by kAlbedoWalks walks
    /// when it is first needed; the specular reflectance of a smooth interface is exact.
    FloatLanes albedo(Vec3f wi) const override;

    static constexpr int kAlbedoIntervals = 16, kAlbedoWalks = 512;

 protected:
    BoundWalk(const WalkTables& tables, const bsdf::Wavelengths& wavelengths_nm);

    /// Follows light until it leaves; empty if it is absorbed.
    virtual std::optional<Escape> follow(const Entry& entry, RandomStream& random) const = 0;

    /// Estimates typical_weight_ by a few walks, from which the probability of the specular lobe
    /// follows. To be called once, when follow() is ready.
    void estimate_typical_weight();

    const Medium& medium() const { return medium_; }
    double index(int lane) const { return index_[lane]; }
    const AirInterface& interface(int lane) const { return *interfaces_[lane]; }

 private:
    struct Packet {
        Lanes weight;
        int lane;
        const bsdf::Patch* patch = nullptr;
    };
    std::optional<bsdf::BsdfSample> walk(const bsdf::Patch* patch, Vec3f wi, float u_select,
                                         Vec2f u) const;
    Packet draw_packet(const bsdf::Patch* patch, RandomStream& random) const;
    Lanes specular_reflectance(double cosine) const;
    std::optional<Escape> enter_and_follow(const Vec3d& wi, const Packet& packet,
                                           RandomStream& random) const;
    std::optional<Escape> meet_rough(const Vec3d& wi, const Packet& packet,
                                     RandomStream& random) const;
    const Lanes& inner_albedo(int i) const;
    Lanes mean_weight(double cosine, int walks, std::uint64_t number, double* mean_square) const;

    Medium medium_;
    std::array<double, kLanes> index_;
    std::array<std::shared_ptr<const AirInterface>, kLanes> interfaces_;
    bool rough_ = false, dispersive_ = false;
    /// Root mean square of the weight with which light leaves that came in with weight 1.
    double typical_weight_ = 1;

    // Over the outer cosine, each when it is first asked for: a flat panel is seen from few directions.
    mutable std::array<std::once_flag, kAlbedoIntervals + 1> albedo_once_;
    mutable std::array<Lanes, kAlbedoIntervals + 1> inner_albedo_;
};

/// A paint whose light is followed flake by flake, by depth alone: the position-free walk of
/// reference.h, for one packet of light at eight wavelengths.   [guo-hasan-zhao-2018; wilkie-2014]
///
/// Only sample() tells what the paint looks like: it sends light in from wi and follows it until it
/// leaves, or reflects it at a smooth interface: samples are of unknown density or specular.
/// eval() and pdf() are zero. A renderer must not weigh them against light sampling, and sees no
/// light source without extent. The same (wi, u_select, u) gives the same walk.
///
/// Supports all that a recipe may say: pigments, several layers, a rough clearcoat. Where the
/// binder's index differs between the eight wavelengths, light bends differently, and each walk
/// carries one of them, drawn at random: unbiased, with coloured noise.
class PlaneWalk final : public bsdf::Bsdf {
 public:
    /// @param wavelengths_nm  where films are computed; between them, R, T and all else are linear
    ///                        in wavelength, beyond them constant
    /// @throws DomainError if the recipe is not valid at these wavelengths
    /// @throws Stopped if `progress`, which is asked while films are computed, says so
    explicit PlaneWalk(
        const paint::Recipe& recipe,
        const std::vector<double>& wavelengths_nm = spectra::default_wavelengths_nm(),
        const Progress& progress = {});
    ~PlaneWalk() override;

    std::unique_ptr<const bsdf::BoundBsdf> bind(
        const bsdf::Wavelengths& wavelengths_nm) const override;

 private:
    std::shared_ptr<const WalkTables> tables_;
};

}  // namespace nacre::montecarlo
