#include "apps/studio/messages/own_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/io/image.h"
#include "nacre/render/environment.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/scene_file.h"
#include "nacre/spectra/colour.h"

namespace nacre::studio {

namespace {

/// Vertices and indices of a glTF: some times what its triangles could have.
constexpr double kMaxOwnElements = 16.0 * kMaxOwnTriangles;
/// Extents that lights and cameras suit, and the one for what is beyond.
constexpr double kSmallest_mm = 50, kLargest_mm = 400, kUsual_mm = 200;
constexpr double kFieldOfView_deg = 15, kAzimuth_deg = -65, kElevation_deg = 18;

void require_size(const std::string& file, std::string_view bytes) {
    if (bytes.empty()) throw InputError(file + ": is empty");
    if (bytes.size() > kMaxOwnFileBytes) {
        throw InputError(fmt::format("{}: has {} bytes; at most {} are taken", file, bytes.size(),
                                     kMaxOwnFileBytes));
    }
}

/// Each pixel the mean of so many by so many.
render::ImageEnvironment reduced(const render::ImageEnvironment& picture, int by) {
    render::ImageEnvironment small = picture;
    small.width = picture.width / by;
    small.height = picture.height / by;
    small.rgb.assign(std::size_t{3} * small.width * small.height, 0.0f);
    for (int y = 0; y < small.height * by; ++y) {
        for (int x = 0; x < small.width * by; ++x) {
            const std::size_t to = 3 * (static_cast<std::size_t>(y / by) * small.width + x / by);
            const std::size_t from = 3 * (static_cast<std::size_t>(y) * picture.width + x);
            for (int c = 0; c < 3; ++c) {
                small.rgb[to + c] += picture.rgb[from + c] / static_cast<float>(by * by);
            }
        }
    }
    return small;
}

/// The luminance of a white panel that lies flat in the light.
double white_luminance(const render::ImageEnvironment& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height / 2; ++y) {
        const double top = std::sin(kHorizon * 2 * y / picture.height);
        const double bottom = std::sin(kHorizon * 2 * (y + 1) / picture.height);
        double row = 0;
        for (int x = 0; x < picture.width; ++x) {
            const float* rgb = &picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width + x)];
            row += spectra::linear_rec709_to_xyz({rgb[0], rgb[1], rgb[2]}).y;
        }
        // Int cos sin over the row, relative to that over the hemisphere.
        sum += row / picture.width * (bottom * bottom - top * top);
    }
    return sum;
}

}  // namespace

std::shared_ptr<const OwnShape> read_own_shape(const std::string& name, const std::string& file,
                                               std::string_view bytes, bool y_up) {
    require_size(file, bytes);
    render::MeshFile read{.path = file, .y_up = y_up};
    auto mesh =
        std::make_shared<const render::Mesh>(render::parse_lone_mesh(bytes, read, kMaxOwnElements));
    if (mesh->triangles.size() > kMaxOwnTriangles) {
        throw InputError(fmt::format("{}: has {} triangles; at most {} are shown", file,
                                     mesh->triangles.size(), kMaxOwnTriangles));
    }
    Vec3f low = mesh->positions_mm.at(0), high = low;
    for (const auto& triangle : mesh->triangles) {
        for (const std::uint32_t i : triangle) {
            const Vec3f& p = mesh->positions_mm[i];
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    }
    const Vec3f size = high - low;
    const double extent = std::max({size.x, size.y, size.z});
    if (!(extent > 1e-6 && extent < 1e9)) {
        throw InputError(
            fmt::format("{}: is {:.4g} mm large; must be in [1e-6, 1e9] mm", file, extent));
    }
    auto own = std::make_shared<OwnShape>();
    own->name = name;
    own->title = file;
    own->extent_mm = extent;
    render::Transform transform;
    if (extent < kSmallest_mm || extent > kLargest_mm) transform.scale = kUsual_mm / extent;
    transform.translation_mm = static_cast<float>(-0.5 * transform.scale) * (low + high);
    read.read = std::move(mesh);
    own->shape = {std::move(read), "paint", transform};

    const double radius = 0.5 * transform.scale * length(size);
    const double distance = 1.02 * radius / std::sin(0.5 * kFieldOfView_deg * kDegree);
    own->camera.position_mm =
        static_cast<float>(distance) * render::direction_from_angles(kAzimuth_deg, kElevation_deg);
    own->camera.vertical_fov_deg = kFieldOfView_deg;
    return own;
}

std::shared_ptr<const OwnLight> read_own_light(const std::string& name, const std::string& file,
                                               std::string_view bytes) {
    require_size(file, bytes);
    if (!io::looks_like_image(bytes)) {
        throw InputError(file + ": is no picture of light; must be Radiance HDR or OpenEXR");
    }
    // Of R, G, B and alpha.
    constexpr std::size_t kMaxValues = std::size_t{4} * (2 * kMaxOwnLightWidth) * kMaxOwnLightWidth;
    const io::Image image = io::parse_image(bytes, file, kMaxValues);
    if (image.width != 2 * image.height) {
        throw InputError(
            fmt::format("{}: has {} x {} pixels; must be twice as wide as high, light from all "
                        "around by longitude and latitude",
                        file, image.width, image.height));
    }
    auto own = std::make_shared<OwnLight>();
    own->name = name;
    own->title = file;
    render::ImageEnvironment& picture = own->picture;
    picture.width = image.width;
    picture.height = image.height;
    picture.rgb = io::interleaved_rgb(image, file);
    own->note = render::without_negative_light(picture.rgb, file);
    const auto wrong =
        std::ranges::find_if(picture.rgb, [](float x) { return !(x >= 0 && std::isfinite(x)); });
    if (wrong != picture.rgb.end()) {
        const auto at = (wrong - picture.rgb.begin()) / 3;
        throw InputError(fmt::format("{}: is {} at column {}, row {}; must be finite and >= 0",
                                     file, *wrong, at % picture.width, at / picture.width));
    }
    if (picture.width > kMaxOwnLightWidth) {
        picture = reduced(picture, (picture.width + kMaxOwnLightWidth - 1) / kMaxOwnLightWidth);
    }
    const double white = white_luminance(picture);
    if (!(white > 1e-12 && white < 1e30)) {
        throw InputError(file + ": sends no light from above that a panel could be seen by");
    }
    for (float& value : picture.rgb) value = static_cast<float>(value / white);
    return own;
}

}  // namespace nacre::studio
