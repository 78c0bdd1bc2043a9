#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/exchange/shading.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/measurement.h"

// A material of another renderer, made to look like a paint: least squares of CIEDE2000 over angles,
// of the format's own BRDF, and how far it remains from the paint.

namespace nacre::exchange {

/// A number that a format gives its material.
struct FormatParameter {
    std::string name;  ///< as the format spells it
    double lo = 0, hi = 1, start = 0.5;
    double power = 1;      ///< a fit steps evenly in ((x - lo) / (hi - lo))^(1/power)
    bool screened = true;  ///< whether a fit seeks its starting point; else it begins at `start`
};

/// The BRDFs of materials by their numbers, in 1/sr, linear Rec. 709, at lamps and views that are
/// given once. Keeps what the next material may share with the last one, as those do of which a fit
/// takes differences: every thread wants its own. `values` are in the order of the parameters.
using FormatBrdfs =
    std::function<void(const std::vector<double>& values, std::vector<Vec3d>& brdfs)>;

/// A material by its numbers.
struct FormatModel {
    std::string format;  ///< for people
    std::vector<FormatParameter> parameters;
    bool coat = false;  ///< a smooth or rough clearcoat lies on top
    double coat_ior = 1.5;
    bool across = false;  ///< is fitted at more views off the plane of incidence
    int trial_steps = 0;  ///< after so many, a fit gives up all but the best descents; 0: none
    std::function<FormatBrdfs(const std::vector<ShadingDirections>& at)> brdfs;
};

/// FormatModel::brdfs of materials that are made of their numbers, by a class for one lamp and view.
template <class At, class MaterialOf>
auto brdfs_by(MaterialOf material_of) {
    return [material_of](const std::vector<ShadingDirections>& at) {
        return [material_of, each = std::vector<At>(at.begin(), at.end())](
                   const std::vector<double>& values, std::vector<Vec3d>& brdfs) mutable {
            const auto material = material_of(values);
            for (std::size_t i = 0; i < each.size(); ++i) brdfs[i] = each[i].brdf(material);
        };
    };
}

/// The lamps and views of a fit, and others that test it: no view of one is in the other.
/// byk-mac's six angles come first in `fitted`.
struct FitGeometries {
    std::vector<measure::Geometry> fitted, tested;
};
/// @param across  more views off the plane, for materials that are free to do anything there
const FitGeometries& fit_geometries(bool across = false);
/// How many of `fitted` are byk-mac's.
inline constexpr std::size_t kBykMacAngles = 6;

struct MaterialFit {
    std::vector<double> values;      ///< of the parameters
    measure::Difference instrument;  ///< at byk-mac's angles, which are fitted
    measure::Difference fitted;      ///< at all angles of the fit
    measure::Difference tested;      ///< at angles that the fit did not see
};

/// The colours of a material under D65 for the 2 degree observer, whose white is (1, 1, 1).
measure::Measurement read_material(const FormatModel& model, const std::vector<double>& values,
                                   const std::vector<measure::Geometry>& geometries);

/// Fits by trust regions from the best points of a Halton sequence and the parameters' own starts;
/// the same result for the same colours.
/// @param fitted, tested  the paint's colours at fit_geometries(), under D65 for 2 degrees
/// @throws Stopped if `progress` asks to stop; Error if no start leads anywhere
MaterialFit fit_material(const FormatModel& model, const measure::Measurement& fitted,
                         const measure::Measurement& tested, const Progress& progress = {});

}  // namespace nacre::exchange
