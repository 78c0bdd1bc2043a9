#pragma once

#include <string>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/exchange/material_fit.h"

// The surface of OpenPBR as MaterialX builds it from its nodes.

namespace nacre::exchange {

/// Inputs of open_pbr_surface, linear Rec. 709. Those that are not here have their defaults, but
/// coat_darkening, which is 0: the estimate of the base's albedo that it rests on would tie the
/// colour of the paint to that of the metal.                             [openpbr-2024]
struct OpenPbr {
    Vec3d base_color{0.8, 0.8, 0.8};  ///< [0, 1]
    double base_metalness = 0;        ///< [0, 1]
    Vec3d specular_color{1, 1, 1};    ///< [0, 1]; of a metal: the tint at 82 deg
    double specular_roughness = 0.3;  ///< [0, 1]; its square is alpha
    double specular_ior = 1.5;        ///< [1, 3]
    double coat_weight = 0;           ///< 0 or 1
    double coat_roughness = 0;        ///< [0, 1]; 0: a mirror, whose lobe is not part of the BRDF
    double coat_ior = kCoatIor;
    /// Half the side of the square in which the slopes of flakes lie evenly, over alpha: normals of
    /// metal and dielectric are tilted cell by cell, not that of the coat.
    double flake_tilt = kFlakeTilt;

    static constexpr double kCoatIor = 1.5, kFlakeTilt = 0.7;
};

/// The mean over flakes of the BRDF in 1/sr, as MaterialX 1.39 evaluates it: albedo-scaled layers,
/// energy compensation [turquin-2019], the metal's Fresnel term with a tint at 82 deg. Directional
/// albedos are integrals here and fits to them there.
/// @param theta_i, theta_o, phi  as measure::Brdf; theta_o is the view's
Vec3d open_pbr_brdf(const OpenPbr& surface, double theta_i, double theta_o, double phi);

/// Schlick's law with a tint at 82 deg.                                  [openpbr-2024]
Vec3d tinted_schlick(double cosine, const Vec3d& f0, const Vec3d& tint);

/// The directional albedo of GGX facets is f0 scale + bias for Schlick's reflectance.
struct SplitAlbedo {
    double scale, bias;
};
SplitAlbedo ggx_albedo(double cosine, double alpha);

/// @param coat, coat_is_rough  as gltf_model()
FormatModel open_pbr_model(bool coat, bool coat_is_rough);
OpenPbr open_pbr(const FormatModel& model, const std::vector<double>& values);

/// A MaterialX 1.39 document of the material, with nodes that tilt normals by a cell noise over the
/// texture coordinates.
std::string materialx_text(const OpenPbr& surface, const std::string& name, const MaterialFit& fit);

}  // namespace nacre::exchange
