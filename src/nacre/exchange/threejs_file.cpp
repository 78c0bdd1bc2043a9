#include "nacre/exchange/threejs_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "nacre/core/base64.h"
#include "nacre/core/error.h"
#include "nacre/core/version.h"
#include "nacre/exchange/material_fit.h"

namespace nacre::exchange {

extern const char* const kThreejsModule;

namespace {

using Json = nlohmann::ordered_json;

double to_hundredths(double value) { return std::round(100 * value) / 100; }

Json about(const std::string& name, const std::string& recipe_sha256,
           const measure::Difference& difference, const std::string& standard) {
    Json by_angle = Json::object(), chips = Json::object();
    for (const measure::AngleDifference& angle : difference.angles) {
        const measure::DisplayPair shown = measure::display_pair(angle);
        by_angle[angle.geometry.name] = to_hundredths(angle.delta_e_2000);
        chips[angle.geometry.name] = {shown.standard, shown.sample};
    }
    return {
        {"name", name},
        {"generator", fmt::format("Nacre {}", version())},
        {"recipe_sha256", recipe_sha256},
        {"colour_differences",
         {{"from", fmt::format("the paint by the model {}, in CIEDE2000 under D65 for 2 degrees",
                               standard)},
          {"by_angle", by_angle},
          {"chips", chips},  // of CSS: the paint's, the material's
          {"mean", to_hundredths(difference.mean_delta_e_2000)},
          {"greatest", to_hundredths(difference.max_delta_e_2000)}}}};
}

const WebglTexture& texture(const WebglShader& shader, std::string_view name) {
    for (const WebglTexture& texture : shader.textures) {
        if (texture.name == name) return texture;
    }
    throw Error(fmt::format("the shader has no texture {}", name));
}

/// Half floats of the smallest byte first, wherever this runs.
std::string bytes_of(const WebglTexture& texture) {
    std::string bytes;
    bytes.reserve(2 * texture.rgba.size());
    for (const std::uint16_t half : texture.rgba) {
        bytes += static_cast<char>(half & 0xff);
        bytes += static_cast<char>(half >> 8);
    }
    return bytes;
}

}  // namespace

const std::vector<measure::Geometry>& shader_geometries() {
    static const std::vector<measure::Geometry> kGeometries = [] {
        std::vector<measure::Geometry> all = measure::find_geometry_set("byk-mac")->geometries;
        for (const double lamp : {15.0, 30.0, 60.0, 75.0}) {
            for (const double aspecular : {15.0, 25.0, 45.0, 75.0}) {
                all.push_back(measure::in_plane(lamp, aspecular));
            }
        }
        return all;
    }();
    return kGeometries;
}

measure::Difference shader_difference(const WebglShader& shader,
                                      const measure::Measurement& standard) {
    FormatModel model;
    model.format = "shader";
    model.brdfs = [&](const std::vector<ShadingDirections>& at) {
        return [&shader, at](const std::vector<double>&, std::vector<Vec3d>& brdfs) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                brdfs[i] = shader.brdf(at[i].l, at[i].v);
                for (int c = 0; c < 3; ++c) brdfs[i][c] = std::max(brdfs[i][c], 0.0);
            }
        };
    };
    std::vector<measure::Geometry> geometries;
    for (const measure::Reading& reading : standard.readings) {
        geometries.push_back(reading.geometry);
    }
    return measure::difference(standard, read_material(model, {}, geometries));
}

std::string threejs_text(const WebglShader& shader, const std::string& name,
                         const std::string& recipe_sha256, const measure::Difference& difference,
                         const std::string& standard) {
    std::string text = kThreejsModule;
    const auto fill = [&](std::string_view mark, const Json& value, int indent = -1) {
        const std::string place = fmt::format("'@{}@'", mark);
        text.replace(text.find(place), place.size(), value.dump(indent, ' ', true));
    };
    const WebglTexture &table = texture(shader, "nacreTable"),
                       &smooth = texture(shader, "nacreSmooth");
    fill("SMOOTH_COAT", shader.smooth_coat);
    fill("TABLE_SIZE", table.size);
    fill("SMOOTH_SIZE", smooth.size);
    fill("GLSL", shader.glsl_with_constants());
    fill("TABLE", base64(bytes_of(table)));
    fill("SMOOTH", base64(bytes_of(smooth)));
    fill("ABOUT", about(name, recipe_sha256, difference, standard),
         2);  // last: a name may look like a mark
    return text;
}

}  // namespace nacre::exchange
