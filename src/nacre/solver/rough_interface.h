#pragma once

#include <memory>
#include <vector>

// The rough boundary between air and coat: a surface of Fresnel facets with Beckmann slopes.
//
// Directions of both sides, outside (index 1) and inside (index n), form one space with the etendue
// n_side^2 |cos| dw as its measure, in which basic radiance L/n_side^2 is scattered by a symmetric
// kernel. Directions x and y point away from the surface. Light from x meets a facet of normal h
// (|h.x| >= 0, on the side of x) with the density of visible normals
//
//     D_x(h) = G1(x) <x.h> D(h) / |cos x|,
//
// and goes on to y: with probability F, Fresnel's reflectance at x.h, to the mirror direction about
// h, otherwise to the refracted one. There it leaves the surface with probability G1(y), else it is
// masked (always, if y lies on the wrong side of the surface). D is Beckmann's microfacet density,
// G1 Smith's masking in its exact form for it. This is
//
//     K(x,y) = F D G1 G1 / (4 |cos x| |cos y|)                                (same side; x 1/n^2)
//     K(x,y) = (1-F) D G1 G1 |x.h| |y.h| / (|cos x| |cos y| (n_x x.h + n_y y.h)^2)   (other side)
//                                                                  [walter-2007, eq. 20, 21, 25]
//
// The masked fraction, m(x) = 1 - Int K(x,y) dy, would meet the surface again. It is returned
// diffusely to both sides, as m(x) m(y) / Int m: reciprocal, and exactly conserving. The idea is
// that of [kulla-conty-2017], on both sides of the surface at once. A random walk samples it so: a
// masked photon goes on to y with the density m(y)/Int m, that is, to the first direction drawn
// uniformly in etendue from which another photon would have been masked.
//
// Limits: for alpha -> 0 a smooth interface. For n -> 1 masked light is still scattered, although
// there is no index step; n = 1 itself is no interface (the solver leaves it out).

namespace nacre::solver {

/// Smith's masking for Beckmann slopes divided by the cosine, finite at grazing.
///                                            [walter-2007, eq. 23; heitz-2014, sec. 5.3]
/// @param cosine, sine  of the angle to the normal, cosine >= 0
double smith_beckmann_over_cosine(double cosine, double sine, double alpha);

/// The interface seen from outside.
class RoughInterface {
 public:
    /// @param ior    index of the coat, in (1, 3]
    /// @param alpha  Beckmann roughness, in (0, 1]
    /// @throws DomainError if one is out of range
    RoughInterface(double ior, double alpha);

    /// BRDF in 1/sr, the masked light that returns to the outside included. phi = phi_o - phi_i.
    double brdf(double theta_i, double theta_o, double phi) const;
    /// The two terms of brdf(): facets, met once; and diffuse_scale() m(theta_i) m(theta_o).
    double facet_brdf(double theta_i, double theta_o, double phi) const;
    double masked(double theta) const;                       ///< m from outside, in [0, 1]
    double diffuse_scale() const { return diffuse_scale_; }  ///< 1 / Int m over both sides, 1/sr

    /// Fraction of the light from outside that the interface reflects.
    double albedo(double theta_i) const;

 private:
    double ior_, alpha_;
    std::vector<double> masked_, reflected_;  // at Gauss-Legendre nodes of theta
    double diffuse_scale_ = 0, masked_outside_ = 0;
};

/// The interface of this index and roughness; the last few are kept.
std::shared_ptr<const RoughInterface> rough_interface(double ior, double alpha);

/// BRDF of the interface alone in 1/sr; 0 at ior = 1. Angles in [0, pi/2), phi = phi_o - phi_i.
double rough_interface_brdf(double ior, double alpha, double theta_i, double theta_o, double phi);

}  // namespace nacre::solver
