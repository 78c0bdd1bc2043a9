#include "nacre/exchange/gltf_material.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/exchange/shading.h"

namespace nacre::exchange {

namespace {

constexpr double kDielectricF0 = 0.04;  ///< of index 1.5, as the specification has it

/// D V of Trowbridge and Reitz with Smith's separable shadowing: f = D V F.
double gltf_specular(const ShadingDirections& at, double alpha) {
    const auto visible = [&](double cosine) {
        return 1 / (cosine + std::sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine));
    };
    return ggx_distribution(at.h.z, alpha) * visible(at.l.z) * visible(at.v.z);
}

double schlick(double f0, double cosine) { return f0 + (1 - f0) * schlick_weight(cosine); }

/// The observer's XYZ of an interference of the given path without a shift of its phase, relative to
/// the mean.                                                             [belcour-barla-2017]
Vec3d sensitivity(double path_nm) {
    constexpr double kValue[3] = {5.4856e-13, 4.4201e-13, 5.2481e-13};
    constexpr double kPosition[3] = {1.6810e6, 1.7953e6, 2.2084e6};
    constexpr double kVariance[3] = {4.3278e9, 9.3046e9, 6.6121e9};
    constexpr double kRedValue = 9.7470e-14, kRedPosition = 2.2399e6, kRedVariance = 4.5282e9;
    constexpr double kScale = 1.0685e-7;
    const double phase = 2 * std::numbers::pi * path_nm * 1e-9;
    const auto lobe = [&](double value, double position, double variance) {
        return value * std::sqrt(2 * std::numbers::pi * variance) * std::cos(position * phase) *
               std::exp(-phase * phase * variance);
    };
    Vec3d xyz;
    for (int c = 0; c < 3; ++c) xyz[c] = lobe(kValue[c], kPosition[c], kVariance[c]);
    xyz.x += lobe(kRedValue, kRedPosition, kRedVariance);
    return xyz / kScale;
}

/// By the specification's own matrix: four digits more would be another format.
Vec3d gltf_rgb(const Vec3d& xyz) {
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// A film at one angle, whatever lies below it.
class GltfFilm {
 public:
    GltfFilm() = default;
    GltfFilm(double cosine, double ior, double nm) : ior_(ior), nm_(nm) {
        const double sine2 = (1 - cosine * cosine) / (ior * ior);
        if (sine2 >= 1) return;
        inside_ = std::sqrt(1 - sine2);
        top_ = schlick(normal_reflectance(ior, 1), cosine);
        const double path = 2 * ior * nm * inside_;
        first_ = sensitivity(path);
        second_ = gltf_rgb(sensitivity(2 * path));
    }
    bool is_of(double ior, double nm) const { return ior == ior_ && nm == nm_; }
    /// @param base  as of gltf_iridescence()
    Vec3d reflectance(const Vec3d& base) const;

 private:
    double ior_ = 0, nm_ = 0;
    double inside_ = 0;  ///< cosine in the film; 0: no light gets in
    double top_ = 1;
    Vec3d first_;   ///< the first order's XYZ
    Vec3d second_;  ///< the second order's RGB
};

Vec3d GltfFilm::reflectance(const Vec3d& base) const {
    if (inside_ == 0) return {1, 1, 1};
    const double top = top_, through = 1 - top;
    Vec3d below, first = first_;
    for (int c = 0; c < 3; ++c) {
        const double root = std::sqrt(std::clamp(base[c], 0.0, 0.9999));
        const double ior = (1 + root) / (1 - root);
        below[c] = schlick(normal_reflectance(ior, ior_), inside_);
        // Half a wavelength is lost at a denser base and at the top: an odd or an even number of
        // turns by pi in the first order, which is none in the second.
        if (!(ior < ior_)) first[c] = -first[c];
    }
    Vec3d sum, amplitude, root;
    for (int c = 0; c < 3; ++c) {
        const double both = std::clamp(top * below[c], 1e-5, 0.9999);
        const double incoherent = through * through * below[c] / (1 - both);
        root[c] = std::sqrt(both);
        sum[c] = top + incoherent;
        amplitude[c] = incoherent - through;
    }
    amplitude = amplitude * root;
    sum += 2.0 * (amplitude * gltf_rgb(first));
    amplitude = amplitude * root;
    sum += 2.0 * (amplitude * second_);
    for (int c = 0; c < 3; ++c) sum[c] = std::max(0.0, sum[c]);
    return sum;
}

/// A lamp and a view, with the last film there.
class GltfAt {
 public:
    explicit GltfAt(const ShadingDirections& at) : at_(at) {}
    Vec3d brdf(const GltfMaterial& m);

 private:
    ShadingDirections at_;
    GltfFilm film_;
};

Vec3d GltfAt::brdf(const GltfMaterial& m) {
    const ShadingDirections& at = at_;
    const double lobe = gltf_specular(at, std::max(kMinGltfAlpha, m.roughness * m.roughness));
    const double weight = schlick_weight(at.vh);
    const Vec3d white = {1, 1, 1};

    Vec3d f0;
    for (int c = 0; c < 3; ++c) f0[c] = std::min(kDielectricF0 * m.specular_color[c], 1.0);
    Vec3d metal = m.base_color + weight * (white - m.base_color);
    Vec3d dielectric = m.specular * (f0 + weight * (white - f0));
    if (m.iridescence > 0) {
        if (!film_.is_of(m.iridescence_ior, m.iridescence_nm)) {
            film_ = GltfFilm(at.vh, m.iridescence_ior, m.iridescence_nm);
        }
        const double weight = m.iridescence;
        metal = (1 - weight) * metal + weight * film_.reflectance(m.base_color);
        dielectric = (1 - weight) * dielectric + weight * m.specular * film_.reflectance(f0);
    }
    const double left = std::max(0.0, 1 - max_component(dielectric));
    Vec3d f = m.metallic * lobe * metal +
              (1 - m.metallic) * (lobe * dielectric + left * std::numbers::inv_pi * m.base_color);
    if (m.clearcoat > 0) {
        const double reflected = m.clearcoat * schlick(kDielectricF0, at.v.z);
        f = (1 - reflected) * f;
        if (m.clearcoat_roughness > 0) {
            const double alpha =
                std::max(kMinGltfAlpha, m.clearcoat_roughness * m.clearcoat_roughness);
            f += reflected * gltf_specular(at, alpha) * white;
        }
    }
    return f;
}

/// In the order of gltf_material().
const std::vector<FormatParameter> kGltfParameters = {
    {"baseColorFactor[0]", 0, 1, 0.5, 2},    {"baseColorFactor[1]", 0, 1, 0.5, 2},
    {"baseColorFactor[2]", 0, 1, 0.5, 2},    {"metallicFactor", 0, 1, 0.8},
    {"roughnessFactor", 0.1, 1, 0.4},        {"specularFactor", 0, 1, 1},
    {"specularColorFactor[0]", 0, 25, 1, 2}, {"specularColorFactor[1]", 0, 25, 1, 2},
    {"specularColorFactor[2]", 0, 25, 1, 2}, {"iridescenceFactor", 0, 1, 0},
    {"iridescenceIor", 1, 3, 1.5},           {"iridescenceThicknessMaximum", 50, 1200, 400},
};

}  // namespace

Vec3d gltf_iridescence(double cosine, double film_ior, double film_nm, const Vec3d& base) {
    return GltfFilm(cosine, film_ior, film_nm).reflectance(base);
}

Vec3d gltf_brdf(const GltfMaterial& material, double theta_i, double theta_o, double phi) {
    return GltfAt(shading_directions(theta_i, theta_o, phi)).brdf(material);
}

FormatModel gltf_model(bool coat, bool coat_is_rough) {
    FormatModel model;
    model.format = "glTF 2.0";
    model.parameters = kGltfParameters;
    if (coat && coat_is_rough)
        model.parameters.push_back({"clearcoatRoughnessFactor", 0.1, 1, 0.3});
    model.coat = coat;
    model.brdfs = brdfs_by<GltfAt>(
        [model](const std::vector<double>& values) { return gltf_material(model, values); });
    return model;
}

GltfMaterial gltf_material(const FormatModel& model, const std::vector<double>& v) {
    GltfMaterial m;
    m.base_color = {v[0], v[1], v[2]};
    m.metallic = v[3];
    m.roughness = v[4];
    m.specular = v[5];
    m.specular_color = {v[6], v[7], v[8]};
    m.iridescence = v[9];
    m.iridescence_ior = v[10];
    m.iridescence_nm = v[11];
    m.clearcoat = model.coat ? 1 : 0;
    if (v.size() > kGltfParameters.size()) m.clearcoat_roughness = v[12];
    return m;
}

}  // namespace nacre::exchange
