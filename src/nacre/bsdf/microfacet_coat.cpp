#include "nacre/bsdf/microfacet_coat.h"

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {
namespace {

constexpr double kIndexWavelength_nm = 550;
constexpr double kMmPerUm = 1e-3;

}  // namespace

double index_around_facets(const layers::Recipe& recipe) {
    return recipe.clearcoat ? recipe.binder.index(kIndexWavelength_nm).real() : 1.0;
}

void validate_microfacet_recipe(const layers::Recipe& recipe) {
    if (!recipe.microfacet) {
        throw DomainError("microfacet: is missing; this model needs the table [microfacet]");
    }
    layers::validate(recipe, {kIndexWavelength_nm});
    if (recipe.clearcoat && recipe.clearcoat->roughness > 0) {
        throw DomainError(fmt::format(
            "clearcoat.roughness = {}: must be 0 over microfacets, which take a smooth coat only",
            recipe.clearcoat->roughness));
    }
}

MicrofacetCoat::MicrofacetCoat(const layers::Recipe& recipe, const Wavelengths& wavelengths_nm)
    : present_(recipe.clearcoat.has_value()),
      ior_(static_cast<float>(index_around_facets(recipe))),
      inverse_ior_(1 / ior_),
      inverse_ior2_(inverse_ior_ * inverse_ior_),
      depth_{} {
    if (present_) {
        depth_ = make_lanes([&](int i) {
            return static_cast<float>(recipe.clearcoat->absorption_per_mm(wavelengths_nm[i]) *
                                      recipe.clearcoat->thickness_um * kMmPerUm);
        });
    }
    absorbs_ = lane_max(depth_) > 0;
}

MicrofacetCoat::Ray MicrofacetCoat::refract(Vec3f outside) const {
    if (!present_) return {outside, outside, 1};
    return {outside, refract_in(outside, inverse_ior_),
            1 - optics::fresnel_dielectric(ior_, outside.z)};
}

std::optional<Vec3f> MicrofacetCoat::leave(Vec3f inside) const {
    return present_ ? refract_out(inside, ior_) : inside;
}

FloatLanes MicrofacetCoat::transfer(const Ray& i, const Ray& o) const {
    if (!present_) return splat(1.0f);
    const float interface = i.transmittance * o.transmittance * inverse_ior2_;
    if (!absorbs_) return splat(interface);
    return interface * exp_lanes(-depth_ * (1 / i.inside.z + 1 / o.inside.z));
}

}  // namespace nacre::bsdf
