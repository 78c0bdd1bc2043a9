#pragma once

#include <array>
#include <memory>
#include <optional>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
#include "nacre/render/emission.h"
#include "nacre/render/scene.h"

namespace nacre::render {

/// Light from infinity as a function of direction, ready for look-ups.
class EnvironmentRadiance {
 public:
    /// Of the spectra that it is a linear combination of; those that it has not are 0.
    using Coefficients = std::array<float, 3>;

    virtual ~EnvironmentRadiance() = default;
    /// Of the radiance arriving from the unit vector `direction`.
    virtual Coefficients coefficients(Vec3f direction) const = 0;
    /// The spectral radiance that coefficients, or a mean of some, stand for. `basis` is
    /// EmissionBasis::at() of the basis that compile_environment() filled.
    virtual FloatLanes combined(const Coefficients& c, const FloatLanes* basis) const = 0;
    /// Its luminance, the brightness that guides sampling.
    virtual float luminance_of(const Coefficients& c) const = 0;
    /// Of luminance 1, with light of all wavelengths.
    virtual Coefficients white() const = 0;

    virtual float luminance(Vec3f direction) const { return luminance_of(coefficients(direction)); }
    FloatLanes radiance(Vec3f direction, const FloatLanes* basis) const {
        return combined(coefficients(direction), basis);
    }
};

/// A disk of constant radiance at infinity: the sun.
struct DistantDisk {
    Vec3f direction;
    /// Squared chord between its middle and its rim, 2 (1 - cos radius): a cosine would keep only
    /// three digits of the sun's size in a float. Its solid angle is pi times this.
    float chord_squared = 0;
    float radiance = 0;  ///< times the basis spectrum
    int spectrum = 0;    ///< in the EmissionBasis
    double luminance = 0;

    bool contains(Vec3f d) const { return dot(d - direction, d - direction) <= chord_squared; }
    IntLanes contains(const Vec3Lanes& d) const {
        const Vec3Lanes apart = d - splat(direction);
        return dot(apart, apart) <= chord_squared;
    }
};

struct CompiledEnvironment {
    std::unique_ptr<const EnvironmentRadiance> radiance;
    std::optional<DistantDisk> sun;
    int table_columns = 1, table_rows = 1;  ///< size of the DirectionDistribution that samples it
    /// Points around the horizon among which no detail is lost; 0: there is none, as in a sky.
    int detail = 0;
    /// Of a latitude-longitude picture, bilinear between the middles of its pixels; else 0.
    int picture_width = 0, picture_height = 0;
};

CompiledEnvironment compile_environment(const Environment& description, EmissionBasis& basis);

/// Unit vector of an azimuth from +x towards +y and an elevation from the horizon to +z.
Vec3f direction_from_angles(double azimuth_deg, double elevation_deg);

/// Angular radius of the sun seen from the earth (mean).
inline constexpr double kSunRadius_deg = 0.2666;

/// The clear-to-hazy sky of Preetham et al., as radiance in units of 10 000 cd/m^2 times scale,
/// with the sun as a disk. Valid for turbidity 1.7 to 10; the fit is at its best from 2 to 6, and
/// near the horizon opposite the sun it is known to be too dark.
///   - luminance and chromaticity: Perez formula          [preetham-1999, eq. 3-4, appendix A.2]
///   - spectrum: phase of daylight of that chromaticity    [preetham-1999, appendix A.5]
///   - sun: black body of 5778 K, 1.88e9 cd/m^2 outside the atmosphere, attenuated by Rayleigh
///     and aerosol scattering                              [preetham-1999, appendix A.1]; ozone
///     and water, a few percent, are neglected
///   - ground: Lambertian, reflectance 0.2, under that sky and sun
CompiledEnvironment compile_sky(const SkyEnvironment& sky, EmissionBasis& basis);

}  // namespace nacre::render
