#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "apps/studio/messages/stage.h"
#include "nacre/core/math.h"
#include "nacre/render/emission.h"
#include "nacre/render/environment.h"
#include "nacre/render/lights.h"
#include "nacre/render/mesh.h"
#include "nacre/spectra/colour.h"

// Shapes and lights as bytes for the live picture.

namespace nacre::studio {

namespace {

static_assert(std::endian::native == std::endian::little, "what is sent is little-endian");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}
void append(std::string& bytes, std::uint32_t value) { append(bytes, &value, 1); }

/// A ball as fine as a picture of it can show; the path tracer's is exact. u runs along azimuth from
/// +x, v from the lower pole up.
render::Mesh ball_mesh(double radius_mm) {
    constexpr int kColumns = 256, kRows = 128;
    return render::mesh_of_surface(kColumns, kRows, [&](double u, double v) {
        const Vec3f normal = render::direction_from_angles(360 * u, 180 * v - 90);
        return render::SurfacePoint{static_cast<float>(radius_mm) * normal, normal};
    });
}

struct MeshOf {
    render::Mesh operator()(const render::Sphere& ball) const { return ball_mesh(ball.radius_mm); }
    template <class Shape>
    render::Mesh operator()(const Shape& shape) const {
        return render::make_mesh(shape);
    }
};

/// The colour of a light by its spectrum, as the path tracer's film has it: linear Rec. 709 by the
/// eye of 2 deg between 400 and 700 nm, relative to D65 of luminance 1.
Vec3d rgb_of_light(const spectra::Spectrum& radiance) {
    const spectra::Spectrum d65 = render::unit_illuminant(spectra::Illuminant::D65);
    const Vec3d white = spectra::linear_rec709_to_xyz({1, 1, 1});
    Vec3d light{}, of_white{};
    for (double nm = render::kFilmFirst_nm; nm <= render::kFilmLast_nm; nm += 1) {
        const Vec3d eye = spectra::colour_matching(spectra::Observer::cie1931_2deg, nm);
        for (int c = 0; c < 3; ++c) {
            light[c] += eye[c] * radiance(nm);
            of_white[c] += eye[c] * d65(nm);
        }
    }
    for (int c = 0; c < 3; ++c) light[c] *= white[c] / of_white[c];
    return spectra::xyz_to_linear_rec709(light);
}

/// The same as it stands in a picture of so many samples a pixel: by their wavelengths. Of few
/// samples lines of a lamp fall between them or on them.
Vec3d rgb_in_picture(const spectra::Spectrum& radiance, int samples) {
    if (samples == 0) return rgb_of_light(radiance);
    const spectra::Spectrum d65 = render::unit_illuminant(spectra::Illuminant::D65);
    const Vec3d white = spectra::linear_rec709_to_xyz({1, 1, 1});
    Vec3d light{}, of_white{};
    for (int sample = 0; sample < samples; ++sample) {
        const bsdf::Wavelengths nm = render::film_wavelengths(static_cast<std::uint32_t>(sample),
                                                              static_cast<std::uint32_t>(samples));
        const render::XyzWeights weights = render::film_xyz_weights(nm);
        for (int lane = 0; lane < kLanes; ++lane) {
            for (int c = 0; c < 3; ++c) {
                light[c] += weights[c][lane] * radiance(nm[lane]);
                of_white[c] += weights[c][lane] * d65(nm[lane]);
            }
        }
    }
    for (int c = 0; c < 3; ++c) light[c] *= white[c] / of_white[c];
    return spectra::xyz_to_linear_rec709(light);
}

Tree json_of(Vec3f v) { return {v.x, v.y, v.z}; }
Tree json_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

spectra::Illuminant lamp_of(const Stage& stage) {
    const render::SceneDescription scene =
        scene_of({.light = stage.light, .own_light = stage.own_light});
    const auto* walls = std::get_if<render::ConstantEnvironment>(&*scene.environment);
    return walls ? walls->radiance.illuminant : spectra::Illuminant::D65;
}

Adaptation::Adaptation(const Stage& stage, int samples) {
    const spectra::Illuminant lamp = lamp_of(stage);
    none_ = lamp == spectra::Illuminant::D65;
    if (none_) return;
    const auto xyz = [](const Vec3d& rgb) { return spectra::linear_rec709_to_xyz(rgb); };
    const Vec3d from = xyz(rgb_in_picture(render::unit_illuminant(lamp), samples));
    for (int c = 0; c < 3; ++c) {
        Vec3d unit{};
        unit[c] = 1;
        columns_[c] =
            spectra::xyz_to_linear_rec709(spectra::adapted(xyz(unit), from, xyz({1, 1, 1})));
    }
}

Vec3d Adaptation::operator()(const Vec3d& rgb) const {
    return none_ ? rgb : rgb.x * columns_[0] + rgb.y * columns_[1] + rgb.z * columns_[2];
}

double aspect_of(const render::SceneDescription& scene) {
    const render::Shape& shape = scene.shapes.at(0);
    const render::AffineMap map(shape.transform);
    const render::Camera& camera = scene.camera;
    double radius_mm = 0;
    for (const Vec3f& position : std::visit(MeshOf(), shape.geometry).positions_mm) {
        const Vec3f at = map.point(position) - camera.target_mm;
        radius_mm = std::max(radius_mm, std::hypot(double{at.x}, double{at.y}));
    }
    const double distance_mm = length(camera.position_mm - camera.target_mm);
    // A circle about the vertical is seen from its side as tan of half an angle.
    const double across =
        radius_mm / std::sqrt(std::max(distance_mm * distance_mm - radius_mm * radius_mm, 1e-9));
    constexpr double kMargin = 1.05, kDetail = 3;
    const double aspect = kMargin * across / std::tan(camera.vertical_fov_deg / 2 * kDegree);
    return aspect > kDetail ? 1.0 : std::max(aspect, 1.0);
}

std::string shape_bytes(const Stage& stage) {
    const render::SceneDescription scene =
        scene_of({.shape = stage.shape, .own_shape = stage.own_shape});
    const render::Mesh mesh = std::visit(MeshOf(), scene.shapes.at(0).geometry);
    const auto vertices = static_cast<std::uint32_t>(mesh.positions_mm.size());
    std::string bytes;
    append(bytes, vertices);
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto* vectors : {&mesh.positions_mm, &mesh.normals}) {
        for (const Vec3f& v : *vectors) {
            const float xyz[] = {v.x, v.y, v.z};
            append(bytes, xyz, 3);
        }
    }
    for (std::uint32_t i = 0; i < vertices; ++i) {
        const Vec2f at = mesh.uv.empty() ? Vec2f{} : mesh.uv[i];
        const float uv[] = {at.x, at.y};
        append(bytes, uv, 2);
    }
    for (const auto& triangle : mesh.triangles) append(bytes, triangle.data(), 3);
    return bytes;
}

std::string light_bytes(const Stage& stage, int width) {
    require_in_range(width, kLightWidth.lo, kLightWidth.hi, "width in pixels");
    const render::SceneDescription scene =
        scene_of({.light = stage.light, .own_light = stage.own_light});
    const Adaptation adapted(stage);
    const int height = width / 2;
    render::EmissionBasis basis;
    const render::CompiledEnvironment environment =
        render::compile_environment(*scene.environment, basis);
    render::LightSet lights(scene.lights, std::nullopt, {0, 0, 0}, 100, basis);

    // Light is linear in the spectra of the basis: with a colour in the place of each spectrum's
    // samples, a look-up gives a colour.
    std::vector<FloatLanes> colours;
    std::vector<Vec3d> rgb;
    for (int i = 0; i < basis.size(); ++i) {
        rgb.push_back(adapted(rgb_of_light(basis[i])));
        const Vec3d& colour = rgb.back();
        colours.push_back(make_lanes(
            [&](int lane) { return lane < 3 ? static_cast<float>(colour[lane]) : 0.0f; }));
    }
    Tree header = {{"name", stage.light}, {"azimuth_deg", render::ImageEnvironment{}.azimuth_deg}};
    header["sun"] = nullptr;
    if (const auto& sun = environment.sun) {
        header["sun"] = {{"direction", json_of(sun->direction)},
                         {"rgb", json_of(static_cast<double>(sun->radiance) * rgb[sun->spectrum])},
                         {"angular_radius_deg", render::kSunRadius_deg}};
    }
    header["rectangles"] = Tree::array();
    for (const render::CompiledRectangle& light : lights.rectangles()) {
        header["rectangles"].push_back(
            {{"corner", json_of(light.corner_mm)},
             {"edge_u", json_of(light.edge_u_mm)},
             {"edge_v", json_of(light.edge_v_mm)},
             {"normal", json_of(light.normal)},
             {"rgb", json_of(static_cast<double>(light.radiance) * rgb[light.spectrum])}});
    }
    std::string text = header.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');

    std::string bytes;
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
    append(bytes, static_cast<std::uint32_t>(width));
    append(bytes, static_cast<std::uint32_t>(height));
    const double first_deg = render::ImageEnvironment{}.azimuth_deg + 180;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Vec3f direction = render::direction_from_angles(
                first_deg - 360 * (column + 0.5) / width, 90 - 180 * (row + 0.5) / height);
            const FloatLanes light = environment.radiance->radiance(direction, colours.data());
            const float values[] = {light[0], light[1], light[2]};
            append(bytes, values, 3);
        }
    }
    return bytes;
}

}  // namespace nacre::studio
