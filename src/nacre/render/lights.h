#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/render/direction_distribution.h"
#include "nacre/render/environment.h"
#include "nacre/render/environment_cells.h"

// The lights of a scene, ready to be sampled. Lights are chosen with fixed probabilities after a
// rough estimate of what each gives at the middle of the scene; every pdf below includes that
// probability.
//
// Where samples of surfaces find light as well, the environment is sampled in proportion to what
// exceeds its mean: surfaces find the rest, which is everywhere, with less noise.
//                                                              [karlik-2019]

namespace nacre::render {

/// Density with which a direction towards a light is drawn, or eight are.
template <class T>
struct LightPdfs {
    float probability = 0;  ///< of choosing the light
    /// Per solid angle then; infinite for light from a single direction.
    T density{};

    T value() const { return probability * density; }
};
using LightPdf = LightPdfs<float>;

/// Where a light was found, or eight were.
template <class T>
struct LightDirection {
    Vec3<T> direction;  ///< from the surface to the light
    T distance{};       ///< infinity for distant lights
    T pdf{};            ///< per solid angle; of a DirectionalLight: the probability alone. 0: none
    T density{};        ///< LightPdf::density
    T brightness{};     ///< roughly the luminance, to choose by; of a DirectionalLight: illuminance
    decltype(T{} < T{}) delta{};  ///< no BSDF sample can find it: it needs no weight
};

struct LightSample : LightDirection<float> {
    FloatLanes radiance;  ///< of a DirectionalLight: irradiance
};

/// Here brightness is roughly the radiance, summed over the wavelengths.
struct LightDirections : LightDirection<FloatLanes> {
    IntLanes light{};  ///< by number
};

/// A rectangle that shines towards its normal.
struct CompiledRectangle {
    Vec3f corner_mm, edge_u_mm, edge_v_mm, normal;
    float area_mm2 = 0, radiance = 0;
    int spectrum = 0;
    bool visible = true;
};

class LightSet {
 public:
    /// @param center_mm, radius_mm  a sphere about the shapes of the scene
    LightSet(const std::vector<Light>& lights, const std::optional<Environment>& environment,
             Vec3f center_mm, float radius_mm, EmissionBasis& basis);

    bool empty() const { return alone_.entries.empty(); }
    const std::vector<CompiledRectangle>& rectangles() const { return rectangles_; }

    /// Draws a light and a direction towards it. Empty where the light's dark side faces the point,
    /// or where surfaces find all there is.
    /// @param alone  whether samples of surfaces find no light, so that these must find all of it
    std::optional<LightSample> sample(Vec3f point_mm, float u_light, Vec2f u,
                                      const FloatLanes* basis, bool alone) const;
    /// Eight draws without radiance; look_at() gives one of them with it.
    LightDirections directions(Vec3f point_mm, FloatLanes u_light, Vec2<FloatLanes> u,
                               const FloatLanes* basis, bool alone) const;
    LightSample look_at(const LightDirections& eight, int lane, const FloatLanes* basis,
                        bool alone) const;

    /// Radiance from infinity, of environment and sun, each weighted by `weight(pdf)`, where pdf,
    /// a LightPdf, is that with which sample() draws this direction from that light beside surfaces.
    template <class Weight>
    FloatLanes escaped(Vec3f direction, const FloatLanes* basis, const Weight& weight) const;

    /// escaped() with a smaller sun spread evenly over a disk of this solid angle, and what is small
    /// and bright in the environment over a cell about as large, for light seen after a
    /// specular reflection. No light sample finds that light, so that few paths or none would meet a sun
    /// much smaller than the solid angle of a sample, as fireflies; spread out it gives as much
    /// light.                                       [kaplanyan-dachsbacher-2013, who spread the mirror]
    FloatLanes escaped_spread(Vec3f direction, float solid_angle, const FloatLanes* basis) const;

    /// Roughly the luminance that lights, were nothing in between, send along eight directions, each
    /// weighted as in escaped(): a guide for sampling. 0 only where no light comes from.
    template <class Weight>
    FloatLanes brightness(Vec3f point_mm, const Vec3Lanes& direction, const Weight& weight) const;

    /// Radiance per brightness() that no light falls short of, at any wavelength: 0 where one lacks light.
    FloatLanes common_colour(const FloatLanes* basis) const;

    FloatLanes rectangle_radiance(int rectangle, const FloatLanes* basis) const {
        const CompiledRectangle& r = rectangles_[rectangle];
        return r.radiance * basis[r.spectrum];
    }
    /// Of sample() beside surfaces, for a point of the rectangle seen at `distance_mm` in
    /// `direction`.
    LightPdf rectangle_pdf(int rectangle, Vec3f direction, float distance_mm) const {
        return {beside_.rectangle_probability[rectangle],
                density_over(rectangles_[rectangle], direction, distance_mm)};
    }

 private:
    enum class Kind { environment, sun, rectangle, directional };
    struct Entry {
        Kind kind;
        int index = 0;
        float probability = 0, cumulative = 0;
    };
    struct Directional {
        Vec3f direction;
        float irradiance;
        int spectrum;
    };

    /// How light samples choose: alone, or beside samples of surfaces.
    struct Choice {
        int entry_at(float u_light) const {
            int at = 0;
            while (u_light >= entries[at].cumulative) ++at;  // the last one's is 1
            return at;
        }

        std::vector<Entry> entries;
        std::optional<DirectionDistribution> environment;
        std::vector<float> rectangle_probability;
        float environment_probability = 0;
        float dimmest = 0;  ///< luminance of an environment over which its table is
        LightPdf sun;
    };
    /// Per solid angle, of points that are even over a rectangle; 0 on its dark side.
    template <class T>
    static T density_over(const CompiledRectangle& r, const Vec3<T>& direction, T distance_mm) {
        const T cosine =
            -(direction.x * r.normal.x + direction.y * r.normal.y + direction.z * r.normal.z);
        const T density = distance_mm * distance_mm / (cosine * r.area_mm2);
        return cosine > 0 ? density : T{};
    }
    const Choice& choice(bool alone) const { return alone ? alone_ : beside_; }
    template <class T>
    LightDirection<T> draw(const Choice& choice, const Entry& entry, Vec3f point_mm,
                           const Vec2<T>& u) const;
    FloatLanes radiance_of(const Entry& entry, Vec3f direction, const FloatLanes* basis) const;
    /// Roughly, the sum over the wavelengths per luminance, of light from these directions.
    FloatLanes sum_per_luminance(const Entry& entry, const Vec3Lanes& direction,
                                 const FloatLanes* basis) const;
    void add(Kind kind, int index, double estimate);
    void normalise(Choice& choice) const;
    template <class T>
    LightPdfs<T> environment_pdf(const Vec3<T>& direction) const {
        return {beside_.environment_probability,
                beside_.environment ? beside_.environment->pdf(direction) : T{}};
    }
    FloatLanes sun_radiance(const FloatLanes* basis) const {
        return sun_->radiance * basis[sun_->spectrum];
    }

    Choice alone_, beside_;
    std::vector<CompiledRectangle> rectangles_;
    std::vector<Directional> directionals_;
    std::unique_ptr<const EnvironmentRadiance> environment_;
    float min_brightness_ = 0;  ///< of it: its cells may miss a detail
    /// Of the environment, per luminance, in cells of DirectionDistribution::to_square(); a single one
    /// where the colour is the same all over.
    std::vector<EnvironmentRadiance::Coefficients> colours_;
    std::optional<DistantDisk> sun_;
    std::optional<EnvironmentCells> cells_;
};

template <class Weight>
FloatLanes LightSet::escaped(Vec3f direction, const FloatLanes* basis, const Weight& weight) const {
    FloatLanes sum{};
    if (environment_) {
        sum += weight(environment_pdf(direction)) * environment_->radiance(direction, basis);
    }
    if (sun_ && sun_->contains(direction)) {
        sum += weight(beside_.sun) * sun_radiance(basis);
    }
    return sum;
}

template <class Weight>
FloatLanes LightSet::brightness(Vec3f point_mm, const Vec3Lanes& direction,
                                const Weight& weight) const {
    FloatLanes sum{};
    if (environment_) {
        // Both tables have the same cells.
        const IntLanes cell = alone_.environment->cell_of(direction);
        const LightPdfs<FloatLanes> pdf{
            beside_.environment_probability,
            beside_.environment ? beside_.environment->pdf_in(cell, direction) : FloatLanes{}};
        sum += weight(pdf) *
               max_lanes(alone_.environment->brightness_in(cell), splat(min_brightness_));
    }
    if (sun_) {
        const LightPdfs<FloatLanes> pdf{beside_.sun.probability, splat(beside_.sun.density)};
        sum += sun_->contains(direction) ? weight(pdf) * static_cast<float>(sun_->luminance)
                                         : FloatLanes{};
    }
    for (std::size_t i = 0; i < rectangles_.size(); ++i) {
        const CompiledRectangle& r = rectangles_[i];
        if (!r.visible) continue;
        const FloatLanes towards = dot(direction, splat(r.normal));
        const FloatLanes distance = dot(r.corner_mm - point_mm, r.normal) / towards;
        const Vec3Lanes at = distance * direction + splat(point_mm - r.corner_mm);
        const FloatLanes u = dot(at, splat(r.edge_u_mm)), v = dot(at, splat(r.edge_v_mm));
        const IntLanes meets = (towards < 0.0f) & (distance > 0.0f) & (u >= 0.0f) & (v >= 0.0f) &
                               (u <= dot(r.edge_u_mm, r.edge_u_mm)) &
                               (v <= dot(r.edge_v_mm, r.edge_v_mm));
        if (!any(meets)) continue;
        const LightPdfs<FloatLanes> pdf{beside_.rectangle_probability[i],
                                        density_over(r, direction, distance)};
        sum += meets ? weight(pdf) * r.radiance : FloatLanes{};
    }
    return sum;
}

}  // namespace nacre::render
