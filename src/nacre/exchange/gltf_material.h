#pragma once

#include <string>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/exchange/material_fit.h"

// The material of glTF 2.0, as the BRDF that its specification gives it.

namespace nacre::exchange {

/// Factors of the core material and of the extensions KHR_materials_specular,
/// KHR_materials_iridescence and KHR_materials_clearcoat; linear Rec. 709.  [khronos-gltf-2021]
struct GltfMaterial {
    Vec3d base_color{1, 1, 1};       ///< [0, 1]
    double metallic = 1;             ///< [0, 1]
    double roughness = 1;            ///< [0, 1]; its square is alpha
    double specular = 1;             ///< [0, 1]
    Vec3d specular_color{1, 1, 1};   ///< [0, 25]: 0.04 times it is at most 1
    double iridescence = 0;          ///< [0, 1]
    double iridescence_ior = 1.3;    ///< >= 1
    double iridescence_nm = 400;     ///< thickness, >= 0
    double clearcoat = 0;            ///< [0, 1]
    double clearcoat_roughness = 0;  ///< [0, 1]; 0: a mirror, whose lobe is not part of eval()
};

/// The BRDF in 1/sr of appendix B with the extensions' changes. Not reciprocal under a clearcoat,
/// which dims what lies below by the view's angle only. All but the clearcoat are bounded below in
/// alpha by kMinGltfAlpha, as renderers do.
/// @param theta_i, theta_o, phi  as measure::Brdf; theta_o is the view's
Vec3d gltf_brdf(const GltfMaterial& material, double theta_i, double theta_o, double phi);

inline constexpr double kMinGltfAlpha = 1e-3;

/// Fresnel's reflectance of a thin film by its colour, with the specification's approximations:
/// Schlick's law at both faces, a real base index from `base`, Gaussians for the observer's
/// sensitivities, two orders of interference.                            [belcour-barla-2017]
/// @param cosine  of the angle with the film's normal in air
/// @param base  reflectance of what is below at normal incidence in air, by channel
Vec3d gltf_iridescence(double cosine, double film_ior, double film_nm, const Vec3d& base);

/// What a fit may change: all that is above but the clearcoat, which is as told.
/// @param coat  whether a clearcoat lies on top: 1, else 0
/// @param coat_is_rough  whether its roughness is free
FormatModel gltf_model(bool coat, bool coat_is_rough);
GltfMaterial gltf_material(const FormatModel& model, const std::vector<double>& values);

}  // namespace nacre::exchange
