#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "nacre/core/quadrature.h"
#include "nacre/exchange/webgl_layout.h"

namespace nacre::exchange {

extern const char* const kWebglGlsl;  // webgl_shader.glsl

namespace {

/// A float of GLSL, which must not be an integer.
std::string glsl_number(double x) { return fmt::format("{:.8e}", x); }

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

/// ln of what gaps let through, at the fraction `u` of a layer's thickness.
std::string gain_text(const WebglShader::Layout& layout, std::size_t layer, const char* u) {
    std::string text = "vec4(0.)";
    for (std::size_t k = 0; k < layout.gaps.size(); ++k) {
        const std::size_t own = layout.gaps[k].layer;
        if (own > layer) break;
        const std::string above =
            own < layer ? fmt::format("nacreLayer[{}].x", own) : std::string("1e30");
        text += fmt::format(
            " + gap{0} * nacreShared({1} * nacreLayer[{2}].x + nacreLayer[{2}].y - "
            "nacreLayer[{3}].y, {4}, "
            "p.spread / nacreGap[{0}])",
            k, u, layer, own, above);
    }
    return text;
}

/// What NACRE light of each layer adds, line by line.
std::string layers_text(const WebglShader::Layout& layout) {
    std::string text;
    const auto line = [&]<class... Args>(fmt::format_string<Args...> format, Args&&... args) {
        if (!text.empty()) text += "\n        ";
        fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
    };
    for (std::size_t k = 0; k < layout.gaps.size(); ++k) {
        line("vec4 gap{} = nacreBoth({}, g, p);", k, layout.gaps[k].coupling);
    }
    std::size_t flakes = 0, pigments = 0;
    for (std::size_t n = 0; n < layout.layers.size(); ++n) {
        const WebglShader::Layout::Layer& layer = layout.layers[n];
        line("here = nacreLayer[{}].x * nacreRate({}, g, p); kernel = vec4(0.);", n,
             layer.extinction);
        for (const auto& flake : layer.flakes) {
            line("kernel += nacreLobe(nacreFlake[{}], p) * nacreRow({}, g, p.cosine);", flakes++,
                 flake.reflectance);
        }
        for (const auto& pigment : layer.pigments) {
            const std::string phase =
                pigment.phase
                    ? fmt::format("nacreRow({}, g, acos(clamp(-p.turned, -1., 1.)) / PI)",
                                  *pigment.phase)
                    : fmt::format("nacreHenyeyGreenstein(nacreAnisotropy[{}], p.turned)", pigments);
            line("kernel += {} * nacreScattering[{} + g];", phase, 4 * pigments++);
        }
        if (layout.gaps.empty()) {
            line("escape = nacreEscape(here);");
        } else {
            line(
                "reach = min(1., NACRE_FARTHEST / max(min(min(here.x, here.y), min(here.z, "
                "here.w)), 1e-20)); escape = vec4(0.);");
            line("for (int k = 0; k < NACRE_NODES; ++k) {{");
            line("    float u = reach * NACRE_NODE[k].x;");
            line("    escape += NACRE_NODE[k].y * exp({} - here * u);", gain_text(layout, n, "u"));
            line("}}");
            line("escape *= reach;");
        }
        line("total += kernel * exp(-depth) * nacreLayer[{}].x * escape;", n);
        line("depth += here;");
    }
    if (layout.closing) {
        line("closing = nacreBoth({}, g, p);", *layout.closing);
        if (layout.ground) {
            line("ground += nacreRgb((exp({}) - closing) * nacreBoth({}, g, p), g);",
                 gain_text(layout, layout.layers.size() - 1, "1."), *layout.ground);
        }
    }
    return text;
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
