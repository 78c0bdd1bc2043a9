#include <fmt/format.h>

#include <utility>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/core/quadrature.h"
#include "nacre/exchange/webgl_layout.h"

namespace nacre::exchange {

extern const char* const kWebglGlsl;  // webgl_shader.glsl

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

void WebglLines::add_for_groups(std::string_view line) {
    for (int g = 0; g < 4; ++g) {
        std::string one(line);
        replace_all(one, "@", fmt::format("{}", g));
        add("{}", one);
    }
}

std::string webgl_gain(const WebglShader::Layout& layout, std::size_t layer, const char* u,
                       const char* indent, WebglLines& lines) {
    std::string gain;
    for (std::size_t k = 0; k < layout.gaps.size(); ++k) {
        const std::size_t own = layout.gaps[k].layer;
        if (own > layer) break;
        const std::string far = fmt::format(
            "{0} * nacreLayer[{1}].x + nacreLayer[{1}].y - "
            "nacreLayer[{2}].y",
            u, layer, own);
        const std::string near =
            own < layer ? fmt::format("{} - nacreLayer[{}].x", far, own) : std::string("0.");
        lines.add("{}float share{} = nacreShared({}, {}, p.spread / nacreGap[{}]);", indent, k, far,
                  near, k);
        gain += fmt::format("{}gap{}[@] * share{}", gain.empty() ? "" : " + ", k, k);
    }
    return gain.empty() ? "vec4(0.)" : gain;
}

void webgl_gaps(const WebglShader::Layout& layout, WebglLines& lines) {
    for (std::size_t k = 0; k < layout.gaps.size(); ++k) {
        lines.add("vec4 gap{}[4];", k);
        lines.add_for_groups(
            fmt::format("gap{}[@] = nacreBoth({}, @, p);", k, layout.gaps[k].coupling));
    }
}

namespace {

void add_layer(const WebglShader::Layout& layout, std::size_t n, std::size_t& flakes,
               std::size_t& pigments, WebglLines& lines) {
    const WebglShader::Layout::Layer& layer = layout.layers[n];
    const bool apart = !layout.species.empty();
    for (std::size_t k = flakes; apart && k < flakes + layer.flakes.size(); ++k) {
        lines.add("float rest{0} = whole ? 1. : nacreRest({0}, p);", k);
    }
    lines.add_for_groups(
        fmt::format("here[@] = nacreLayer[{}].x * nacreRate({}, @, p); kernel[@] = vec4(0.);", n,
                    layer.extinction));
    for (const auto& flake : layer.flakes) {
        const std::string rest = apart ? fmt::format(" * rest{}", flakes) : "";
        lines.add("lobe = nacreLobe(nacreFlake[{}], p){};", flakes, rest);
        lines.add_for_groups(
            fmt::format("kernel[@] += lobe * nacreRow({}, @, p.cosine);", flake.reflectance));
        ++flakes;
    }
    for (const auto& pigment : layer.pigments) {
        std::string phase = "lobe";
        if (pigment.phase) {
            lines.add("angle = acos(clamp(-p.turned, -1., 1.)) / PI;");
            phase = fmt::format("nacreRow({}, @, angle)", *pigment.phase);
        } else {
            lines.add("lobe = nacreHenyeyGreenstein(nacreAnisotropy[{}], p.turned);", pigments);
        }
        lines.add_for_groups(
            fmt::format("kernel[@] += {} * nacreScattering[{} + @];", phase, 4 * pigments++));
    }
    if (layout.gaps.empty()) {
        lines.add_for_groups("escape[@] = nacreEscape(here[@]);");
    } else {
        lines.add_for_groups("escape[@] = vec4(0.);");
        lines.add(
            "reach = min(1., NACRE_FARTHEST / max(nacreLeast(min(min(here[0], here[1]), "
            "min(here[2], here[3]))), 1e-20));");
        lines.add("node = 0;");
        lines.add("do {{");
        lines.add("    float u = reach * NACRE_NODE[node].x, weight = reach * NACRE_NODE[node].y;");
        const std::string gain = webgl_gain(layout, n, "u", "    ", lines);
        lines.add_for_groups(fmt::format(
            "    escape[@] += weight * exp(min({} - here[@] * u, {:.1f}));", gain, bsdf::kMaxGain));
        lines.add("}} while (++node < NACRE_NODES);");
    }
    lines.add_for_groups(fmt::format(
        "once += nacreRgb(kernel[@] * exp(-depth[@]) * nacreLayer[{}].x * escape[@], @);", n));
    lines.add_for_groups("depth[@] += here[@];");
}

/// The body of nacreLight().
std::string layers_text(const WebglShader::Layout& layout) {
    WebglLines lines;
    webgl_gaps(layout, lines);
    std::size_t flakes = 0, pigments = 0;
    for (std::size_t n = 0; n < layout.layers.size(); ++n) {
        add_layer(layout, n, flakes, pigments, lines);
    }
    if (!layout.compensation) {
        lines.add("rest = vec3(1.);");
        return std::move(lines).text();
    }
    const std::string gain = webgl_gain(layout, layout.layers.size() - 1, "1.", "", lines);
    lines.add_for_groups(fmt::format(
        "compensation = nacreBoth({}, @, p); rest += nacreRgb(compensation, @); "
        "ground += nacreRgb((exp(min({}, {:.1f})) - compensation) * nacreBoth({}, @, p), @);",
        *layout.compensation, gain, bsdf::kMaxGain, *layout.ground));
    return std::move(lines).text();
}

}  // namespace

std::vector<WebglNode> webgl_nodes() {
    std::vector<WebglNode> nodes;
    const Quadrature& rule = unit_gauss_legendre(10);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double s = rule.nodes[k];
        nodes.push_back({s * s, 2 * s * rule.weights[k]});
    }
    return nodes;
}

std::string webgl_glsl(const WebglShader::Layout& layout, const std::string& numbers) {
    std::string structure = fmt::format("#define NACRE_ROWS {}\n", kWebglRows);
    const auto define = [&](const char* name, int value) {
        structure += fmt::format("#define {} {}\n", name, value);
    };
    define("NACRE_SMOOTH_COAT", layout.roughness == 0);
    define("NACRE_GAPS", !layout.gaps.empty());
    define("NACRE_ALBEDO", layout.albedo.value_or(-1));
    if (!layout.species.empty()) define("NACRE_FLAKES", static_cast<int>(layout.species.size()));
    if (layout.masked) {
        define("NACRE_MASKED", *layout.masked);
        define("NACRE_MASKING", *layout.masking);
    }
    std::string nodes;
    const std::vector<WebglNode> rule = webgl_nodes();
    for (const WebglNode& node : rule) {
        nodes += fmt::format("{}vec2({}, {})", nodes.empty() ? "" : ", ", glsl_number(node.place),
                             glsl_number(node.weight));
    }
    std::string text = kWebglGlsl;
    replace_all(text, "@STRUCTURE@\n", structure);
    replace_all(text, "@NUMBERS@\n", numbers);
    replace_all(text, "@FARTHEST@", glsl_number(kFarthestDepth));
    replace_all(text, "@NODE_COUNT@", fmt::format("{}", rule.size()));
    replace_all(text, "@NODES@", "vec2[](" + nodes + ")");
    replace_all(text, "@LAYERS@", layers_text(layout));
    replace_all(
        text, "@FLAKES@\n",
        layout.species.empty()
            ? ""
            : "/// Of a species, what single flakes are not: 1 of their mean where none are "
              "shown.\nfloat nacreRest(int species, NacrePair p);\n\n");
    if (!layout.species.empty()) text += webgl_flakes_glsl(layout);
    WebglLines depths;
    depths.add_for_groups("depth[@] = nacreDepth[@] * path;");
    replace_all(text, "@DEPTHS@", std::move(depths).text());
    return text;
}

std::string WebglShader::glsl_with_constants() const {
    std::string numbers;
    for (const WebglUniform& uniform : uniforms) {
        const auto size = static_cast<std::size_t>(uniform.components);
        const std::string type = size == 1 ? "float" : fmt::format("vec{}", size);
        std::string elements;
        for (std::size_t at = 0; at < uniform.values.size(); at += size) {
            std::string one;
            for (std::size_t c = at; c < at + size; ++c) {
                one += (one.empty() ? "" : ", ") + glsl_number(uniform.values[c]);
            }
            elements += (elements.empty() ? "" : ", ") + (size == 1 ? one : type + "(" + one + ")");
        }
        numbers += uniform.array ? fmt::format("const {0} {1}[{2}] = {0}[]({3});\n", type,
                                               uniform.name, uniform.values.size() / size, elements)
                                 : fmt::format("const {} {} = {};\n", type, uniform.name, elements);
    }
    return webgl_glsl(*layout, numbers);
}

}  // namespace nacre::exchange
