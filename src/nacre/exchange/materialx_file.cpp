#include <fmt/format.h>

#include <string>

#include "nacre/core/version.h"
#include "nacre/exchange/open_pbr.h"

namespace nacre::exchange {

namespace {

/// Of an XML attribute: MaterialX takes the UTF-8 of a recipe as it is.
std::string attribute(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&') {
            safe += "&amp;";
        } else if (c == '<') {
            safe += "&lt;";
        } else if (c == '"') {
            safe += "&quot;";
        } else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
            safe += ' ';
        } else {
            safe += c;
        }
    }
    return safe;
}

std::string colour(const Vec3d& c) { return fmt::format("{:.6g}, {:.6g}, {:.6g}", c.x, c.y, c.z); }

struct Input {
    const char *name, *type;
    std::string value;
};

std::string input(const Input& i, const char* indent) {
    return fmt::format("{}<input name=\"{}\" type=\"{}\" value=\"{}\" />\n", indent, i.name, i.type,
                       i.value);
}

/// Slopes of cells, even within +-tilt: two cell noises, of which the second is shifted by whole
/// cells, as a normal in the tangent frame.
std::string flake_nodes(double tilt) {
    return fmt::format(R"(  <nodegraph name="flakes">
    <input name="cells" type="float" value="400" uiname="Cells per unit of texture" />
    <texcoord name="place" type="vector2" />
    <multiply name="cell" type="vector2">
      <input name="in1" type="vector2" nodename="place" />
      <input name="in2" type="float" interfacename="cells" />
    </multiply>
    <add name="other_cell" type="vector2">
      <input name="in1" type="vector2" nodename="cell" />
      <input name="in2" type="vector2" value="1031, 577" />
    </add>
    <cellnoise2d name="along" type="float">
      <input name="texcoord" type="vector2" nodename="cell" />
    </cellnoise2d>
    <cellnoise2d name="across" type="float">
      <input name="texcoord" type="vector2" nodename="other_cell" />
    </cellnoise2d>
    <remap name="slope_along" type="float">
      <input name="in" type="float" nodename="along" />
      <input name="outlow" type="float" value="{0:.6g}" />
      <input name="outhigh" type="float" value="{1:.6g}" />
    </remap>
    <remap name="slope_across" type="float">
      <input name="in" type="float" nodename="across" />
      <input name="outlow" type="float" value="{0:.6g}" />
      <input name="outhigh" type="float" value="{1:.6g}" />
    </remap>
    <combine3 name="encoded" type="vector3">
      <input name="in1" type="float" nodename="slope_along" />
      <input name="in2" type="float" nodename="slope_across" />
      <input name="in3" type="float" value="1" />
    </combine3>
    <normalmap name="tilted" type="vector3">
      <input name="in" type="vector3" nodename="encoded" />
    </normalmap>
    <output name="normal" type="vector3" nodename="tilted" />
  </nodegraph>
)",
                       0.5 - 0.5 * tilt, 0.5 + 0.5 * tilt);
}

}  // namespace

std::string materialx_text(const OpenPbr& s, const std::string& name, const MaterialFit& fit) {
    std::string text = "<?xml version=\"1.0\"?>\n";
    text += fmt::format(
        "<!-- Nacre {}: CIEDE2000 from the paint, mean and greatest: {:.1f}, {:.1f} at "
        "byk-mac's angles; {:.1f}, {:.1f} at angles that the fit did not see -->\n",
        version(), fit.instrument.mean_delta_e_2000, fit.instrument.max_delta_e_2000,
        fit.tested.mean_delta_e_2000, fit.tested.max_delta_e_2000);
    text += "<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
    const double tilt = s.flake_tilt * s.specular_roughness * s.specular_roughness;
    text += flake_nodes(tilt);
    text += "  <open_pbr_surface name=\"paint_surface\" type=\"surfaceshader\">\n";
    const auto number = [](double v) { return fmt::format("{:.6g}", v); };
    for (const Input& i : {Input{"base_weight", "float", "1"},
                           {"base_color", "color3", colour(s.base_color)},
                           {"base_metalness", "float", number(s.base_metalness)},
                           {"specular_weight", "float", "1"},
                           {"specular_color", "color3", colour(s.specular_color)},
                           {"specular_roughness", "float", number(s.specular_roughness)},
                           {"specular_ior", "float", number(s.specular_ior)},
                           {"coat_weight", "float", number(s.coat_weight)},
                           {"coat_roughness", "float", number(s.coat_roughness)},
                           {"coat_ior", "float", number(s.coat_ior)},
                           {"coat_darkening", "float", "0"}}) {
        text += input(i, "    ");
    }
    text +=
        "    <input name=\"geometry_normal\" type=\"vector3\" nodegraph=\"flakes\" "
        "output=\"normal\" />\n";
    text += "  </open_pbr_surface>\n";
    text += fmt::format(
        "  <surfacematerial name=\"paint\" type=\"material\" uiname=\"{}\">\n"
        "    <input name=\"surfaceshader\" type=\"surfaceshader\" "
        "nodename=\"paint_surface\" />\n  </surfacematerial>\n</materialx>\n",
        attribute(name));
    return text;
}

}  // namespace nacre::exchange
