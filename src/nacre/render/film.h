#pragma once

#include <utility>
#include <vector>

#include "nacre/render/film_sums.h"
#include "nacre/render/integrator.h"
#include "nacre/render/render.h"

namespace nacre::render {

/// Gathers the light of paths, a pass at a time, and makes the picture of it. A pixel is touched by
/// one thread at a time.
class Film {
 public:
    /// One that goes on from these sums.
    explicit Film(FilmSums sums);

    /// Prepares for the paths of one pass; called once before its add().
    void begin_pass(const Pass& pass, bool with_albedo);
    /// Has the sums of a pixel brought into the cache, for an add() that comes later.
    void prefetch(std::size_t pixel) const;
    void add(std::size_t pixel, const Pass& pass, const PathLight& path);
    /// Ends a pass over all pixels. Not called after a partial one, which develop() counts for the
    /// pixels that it reached.
    void end_pass();

    /// The picture so far.
    ///
    /// XYZ are scaled, each by a factor of its own within two percent of 1, so that D65 comes out
    /// exactly white: this makes up for the eye's sensitivity beyond the film's range and for the
    /// finite number of wavelengths that a short render has seen.
    RenderResult develop() const;

    /// Of the passes that are done; another one must not be under way.
    FilmSums take_sums() { return std::move(sums_); }

 private:
    struct Splat {  // of one lane onto two neighbouring bins
        int bin;
        float weight, next_weight;
    };
    Vec3d colour(const SumTriple<LightSum>& sum, const SumTriple<LightSum>& d65) const;
    void develop_bins(const PassSums& passes, bool ahead, RenderResult& result) const;

    FilmSums sums_;  // their passes: without the one that is under way
    int bins_;
    bool with_albedo_ = false;
    std::array<Splat, kLanes> splats_{};
    PassSums with_current_;            // and with it
    std::vector<std::uint8_t> ahead_;  // the pixels that this pass got to
};

}  // namespace nacre::render
