#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/exchange/material_fit.h"

// A material of Blender's Cycles, made of its shader nodes, as the BRDF that Cycles gives it.

namespace nacre::exchange {

/// A Color Ramp node of stops at even places with B-spline interpolation, linear Rec. 709: a
/// uniform cubic spline whose end stops count twice, so that it is smooth and stays between them.
struct CyclesRamp {
    static constexpr int kStops = 4;
    std::array<Vec3d, kStops> stops{};  ///< [0, 1]

    /// @param place  in [0, 1]
    Vec3d at(double place) const;
};

/// A Glossy BSDF node with Beckmann facets, whose inputs depend on the angle theta of the view.
struct CyclesLobe {
    double roughness = 0.4;  ///< (0, 1], of the view along the normal; its square is alpha
    double widening = 0;     ///< [0, 1]: alpha grows with cos(theta)^-widening, up to 1
    double lean = 0;   ///< [-0.4, 0.5]: slope of its normal towards the view over sin cos(theta)
    CyclesRamp color;  ///< by theta over 90 deg
};

/// Closures that are added below a coat. The diffuse colour and the lobes' are at most 1 together, at
/// each stop, so that they make no light.
struct CyclesMaterial {
    static constexpr int kLobes = 3;
    Vec3d diffuse;
    std::array<CyclesLobe, kLobes> lobes;
    bool coat = false;
    double coat_ior = 1.5;      ///< >= 1
    double coat_roughness = 0;  ///< [0, 1]; 0: a mirror, whose lobe is not part of cycles_brdf()
};

/// The BRDF in 1/sr. Beckmann facets with heights correlated in their shadowing [heitz-2014] and the
/// rational fit to Smith's term of [walter-2007]; Fresnel's law of the coat by the view's angle. Not
/// reciprocal: nodes know the view and not the lamp.
/// @param theta_i, theta_o, phi  as measure::Brdf; theta_o is the view's
Vec3d cycles_brdf(const CyclesMaterial& material, double theta_i, double theta_o, double phi);

/// What a fit may change: all that is above but the coat's presence and index. Colours are shares of
/// what the ramps before them leave of 1.
/// @param coat, coat_is_rough  as gltf_model() @param coat_ior  >= 1
FormatModel cycles_model(bool coat, bool coat_is_rough, double coat_ior);
CyclesMaterial cycles_material(const FormatModel& model, const std::vector<double>& values);

/// The numbers that the script holds, by names as "lobe 1 color[0][1]": of its first stop, green.
std::vector<std::pair<std::string, double>> cycles_parameters(const CyclesMaterial& material);

/// A script for Blender, 4.2 or later, that makes a node group and a material of it. Its flakes are
/// cells of a Voronoi texture with tilted normals.
/// @param flake_um  mean size of the flakes, um, > 0; a unit of the object is taken as 1 m
std::string cycles_text(const CyclesMaterial& material, const std::string& name,
                        const MaterialFit& fit, double flake_um);

}  // namespace nacre::exchange
