#include "nacre/bsdf/models/lambertian.h"

#include <numbers>
#include <utility>

#include "nacre/bsdf/warp.h"
#include "nacre/core/error.h"

namespace nacre::bsdf {
namespace {

constexpr float kInvPi = std::numbers::inv_pi_v<float>;

class BoundLambertian final : public BoundBsdf {
 public:
    explicit BoundLambertian(FloatLanes reflectance) : reflectance_(reflectance) {}

    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        return wi.z > 0 && wo.z > 0 ? kInvPi * reflectance_ : FloatLanes{};
    }
    std::optional<BsdfSample> sample(Vec3f wi, float /*u_select*/, Vec2f u) const override {
        const Vec3f wo = cosine_hemisphere(u);
        if (wi.z <= 0 || wo.z <= 0) return std::nullopt;
        return BsdfSample{wo, reflectance_, kInvPi * wo.z};
    }
    float pdf(Vec3f wi, Vec3f wo) const override {
        return wi.z > 0 && wo.z > 0 ? kInvPi * wo.z : 0;
    }
    FloatLanes albedo(Vec3f wi) const override { return wi.z > 0 ? reflectance_ : FloatLanes{}; }

 private:
    FloatLanes reflectance_;
};

}  // namespace

Lambertian::Lambertian(spectra::Spectrum reflectance) : reflectance_(std::move(reflectance)) {
    require_in_range(reflectance_.min(), 0, 1, "smallest diffuse reflectance");
    require_in_range(reflectance_.max(), 0, 1, "largest diffuse reflectance");
}

std::unique_ptr<const BoundBsdf> Lambertian::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundLambertian>(
        make_lanes([&](int i) { return static_cast<float>(reflectance_(wavelengths_nm[i])); }));
}

}  // namespace nacre::bsdf
