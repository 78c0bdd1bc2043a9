#pragma once

#include <vector>

#include "nacre/render/integrator.h"
#include "nacre/render/render.h"

namespace nacre::render {

/// Sums over the paths of each pixel. A pixel is touched by one thread at a time and its sums
/// grow in the order of the passes, so they do not depend on the number of threads.
class Film {
 public:
    Film(int width, int height, int spectral_bins, bool with_sparkle);

    /// Prepares for the paths of one pass; called once before its add().
    void begin_pass(const Pass& pass, bool with_albedo);
    void add(std::size_t pixel, const Pass& pass, const PathLight& path);
    /// Counts the pass as done by every pixel. A last pass may lack it: it counts for the pixels
    /// that it got to.
    void end_pass();

    /// The picture so far.
    ///
    /// XYZ are scaled, each by a factor of its own within a percent of 1, so that D65 comes out
    /// exactly white: this makes up for the eye's sensitivity beyond the film's range and for the
    /// finite number of wavelengths that a short render has seen.
    RenderResult develop() const;

 private:
    struct Splat {  // of one lane onto two neighbouring bins
        int bin;
        float weight, next_weight;
    };
    /// Sums over passes, the same for all pixels that had as many.
    struct Passes {
        int count = 0;
        Vec3d d65, albedo_d65;  // XYZ of D65
        std::vector<double> bin_weights;
    };
    Vec3d colour(const Vec3d& sum, const Vec3d& d65) const;
    void develop_bins(const Passes& passes, bool ahead, RenderResult& result) const;

    int width_, height_, bins_;
    bool with_albedo_ = false;
    std::array<Splat, kLanes> splats_{};
    Passes done_, with_current_;       // without the pass that is under way, and with it
    std::vector<std::uint8_t> ahead_;  // the pixels that this pass got to
    std::vector<Vec3d> xyz_, albedo_;
    std::vector<Vec3d> sparkle_;  // empty unless asked for
    std::vector<Vec3f> normal_;
    std::vector<float> met_;
    std::vector<float> spectral_;
    std::vector<std::uint32_t> invalid_;
};

}  // namespace nacre::render
