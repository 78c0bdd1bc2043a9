#include "apps/studio/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/text.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/fit/free_numbers.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/difference.h"
#include "nacre/models/models.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/spectra/colour.h"

namespace nacre::studio {

namespace {

/// The name of a page's recipe in messages.
constexpr const char* kRecipeFile = "recipe.toml";

/// A component below 0 by more than this fraction of the largest is out of gamut (io::outside_gamut).
constexpr double kGamutTolerance = 1e-3;

Tree or_null(const std::optional<double>& x) { return x ? Tree(*x) : Tree(nullptr); }

/// A colour on a display on which the perfect diffuser is white: sRGB, not clipped.
struct DisplayColour {
    Vec3d srgb;
    bool out_of_gamut, too_bright;
};

DisplayColour display_colour(const Vec3d& lab) {
    const Vec3d linear = spectra::lab_to_linear_rec709(lab);
    const double largest = std::max({linear.x, linear.y, linear.z});
    const double smallest = std::min({linear.x, linear.y, linear.z});
    DisplayColour colour{
        {}, smallest<-kGamutTolerance * std::abs(largest), largest> 1 + kGamutTolerance};
    for (int c = 0; c < 3; ++c) colour.srgb[c] = spectra::srgb_encode(linear[c]);
    return colour;
}

/// Names, colours and spectra of readings, by geometry.
Tree colours_json(const Measurement& measurement) {
    Tree names = Tree::array(), lab = Tree::array(), rgb = Tree::array(), out = Tree::array(),
         bright = Tree::array(), reflectance = Tree::array();
    for (const measure::Reading& reading : measurement.readings) {
        const DisplayColour colour = display_colour(reading.lab);
        names.push_back(reading.geometry.name);
        lab.push_back(reading.lab);
        rgb.push_back(colour.srgb);
        out.push_back(colour.out_of_gamut);
        bright.push_back(colour.too_bright);
        reflectance.push_back(reading.reflectance_factor);
    }
    return {{"name", measurement.name},
            {"illuminant", spectra::name(measurement.conditions.illuminant)},
            {"observer", spectra::name(measurement.conditions.observer)},
            {"geometries", std::move(names)},
            {"lab", std::move(lab)},
            {"rgb", std::move(rgb)},
            {"out_of_gamut", std::move(out)},
            {"too_bright", std::move(bright)},
            {"wavelengths_nm", measurement.wavelengths_nm},
            {"reflectance", std::move(reflectance)}};
}

Tree travel_json(const Measurement& measurement) {
    const measure::ColourTravel travel = measure::colour_travel(measurement);
    Tree path = Tree::array();
    for (const measure::Reading* reading : travel.path) {
        path.push_back(
            {{"geometry", reading->geometry.name}, {"a", reading->lab[1]}, {"b", reading->lab[2]}});
    }
    return {{"theta_i_deg", measure::kUsualLamp_deg},
            {"length", travel.length},
            {"path", std::move(path)}};
}

/// Differences at the sample's geometries; null where the standard was not read.
Tree difference_json(const Measurement& standard, const Measurement& sample,
                     const measure::Tolerance& tolerance) {
    Tree json = colours_json(standard);
    measure::Difference difference;
    measure::Verdict verdict;
    try {
        difference = measure::difference(standard, sample);
        verdict = measure::judge(difference, known_limits(tolerance, difference));
    } catch (const DomainError& error) {
        json["problem"] = error.what();
        return json;
    }
    Tree columns[6] = {Tree::array(), Tree::array(), Tree::array(),
                       Tree::array(), Tree::array(), Tree::array()};
    Tree passes = Tree::array(), limits = Tree::array(), own = Tree::array();
    for (const measure::Reading& reading : sample.readings) {
        const auto found = std::ranges::find_if(difference.angles, [&](const auto& angle) {
            return measure::separation_deg(angle.geometry, reading.geometry) <= 0.1;
        });
        if (found == difference.angles.end()) {
            for (Tree& column : columns) column.push_back(nullptr);
            for (Tree* column : {&passes, &limits, &own}) column->push_back(nullptr);
            continue;
        }
        const double values[] = {found->delta_e_2000, found->delta_lab[0],   found->delta_lab[1],
                                 found->delta_lab[2], found->delta_chroma(), found->delta_hue()};
        for (int c = 0; c < 6; ++c) columns[c].push_back(values[c]);
        const auto& judged = verdict.angles[found - difference.angles.begin()];
        own.push_back(judged.delta_e);
        limits.push_back(or_null(judged.limit));
        passes.push_back(judged.limit ? Tree(judged.passes()) : Tree(nullptr));
    }
    const char* names[] = {"delta_e_2000", "dL", "da", "db", "dC", "dH"};
    for (int c = 0; c < 6; ++c) json[names[c]] = std::move(columns[c]);
    json["mean"] = difference.mean_delta_e_2000;
    json["max"] = difference.max_delta_e_2000;
    json["formula"] = verdict.tolerance.formula.name();
    json["delta_e"] = std::move(own);
    json["tolerance"] = std::move(limits);
    json["passes"] = std::move(passes);
    json["all_pass"] = verdict.tolerance.has_limits() ? Tree(verdict.passes()) : Tree(nullptr);
    return json;
}

/// Every number of a recipe as a slider needs it.
Tree numbers_json(const Paint& paint) {
    Tree numbers = Tree::array();
    for (const paint::RecipeParameter& parameter : paint::recipe_parameters(paint.recipe())) {
        Tree number = {{"key", parameter.key},
                       {"value", parameter.value},
                       {"unit", parameter.range.unit},
                       {"min", parameter.range.lo},
                       {"max", parameter.range.hi}};
        const auto& given = paint.bounds();
        const auto own = std::ranges::find(given, parameter.key, &paint::ParameterBounds::key);
        if (own != given.end()) {
            number["usual"] = {own->lo, own->hi};
        } else {
            try {
                const auto usual = fit::default_bounds(paint.recipe(), parameter.key);
                number["usual"] = {usual.lo, usual.hi};
            } catch (const DomainError&) {  // of a 0 nothing tells how large it may become
                number["usual"] = nullptr;
            }
        }
        number["in_fit"] = own != given.end();
        numbers.push_back(std::move(number));
    }
    return numbers;
}

Tree recipe_json(const NamedPaint& named, const Tree& tree, const Tree& id) {
    Tree warnings = Tree::array();
    for (const std::string& warning : named.paint.implausible_numbers()) {
        warnings.push_back(warning);
    }
    for (const SolverWarning& warning : named.paint.warnings()) warnings.push_back(warning.message);
    return {{"type", "recipe"},
            {"id", id},
            {"name", named.paint.recipe().name},
            {"sha256", named.paint.recipe_sha256()},
            {"toml", named.toml},
            {"tree", tree},
            {"numbers", numbers_json(named.paint)},
            {"warnings", std::move(warnings)}};
}

Tree uniform_json(const exchange::WebglUniform& uniform) {
    return {{"name", uniform.name},
            {"components", uniform.components},
            {"array", uniform.array},
            {"values", uniform.values}};
}

/// What a message says of a texture, whose texels are added to the bytes that follow it.
Tree texture_json(const exchange::WebglTexture& texture, std::string& bytes) {
    std::vector<int> shape(texture.size.rbegin(), texture.size.rend());
    shape.push_back(4);
    // Texels of four halves need no padding.
    bytes.append(reinterpret_cast<const char*>(texture.rgba.data()),
                 texture.rgba.size() * sizeof(texture.rgba[0]));
    return {{"name", texture.name}, {"dtype", "f16"}, {"shape", shape}};
}

/// Texts and arrays of the shader that shows the paint.
Frame shader_frame(const Paint& paint, spectra::Illuminant lamp, const Context& context) {
    Tree json = {{"type", "shader"}, {"id", context.id}};
    exchange::WebglShader shader;
    try {
        shader = exchange::make_live_webgl_shader(paint.solved({}, context.progress), 0, lamp);
    } catch (const DomainError& error) {  // it has readings all the same
        json["problem"] = error.what();
        return {dumped(json), {}};
    }
    json["program"] = shader.program;
    json["smooth_coat"] = shader.smooth_coat;
    json["uniforms"] = Tree::array();
    for (const exchange::WebglUniform& uniform : shader.uniforms) {
        json["uniforms"].push_back(uniform_json(uniform));
    }
    std::string bytes;
    json["binary"] = Tree::array();
    for (const exchange::WebglTexture& texture : shader.textures) {
        json["binary"].push_back(texture_json(texture, bytes));
    }
    Tree when_new = json;
    when_new["glsl"] = shader.glsl;
    return {dumped(json), std::move(bytes), shader.program, dumped(when_new)};
}

Frame done(const Tree& id) { return {dumped({{"type", "done"}, {"id", id}}), {}}; }

}  // namespace

// ---------------------------------------------------------------------------------- memory

std::shared_ptr<const Paint> Memory::standard() const {
    const std::lock_guard lock(mutex_);
    return standard_;
}
void Memory::set_standard(std::shared_ptr<const Paint> standard) {
    const std::lock_guard lock(mutex_);
    standard_ = std::move(standard);
}
std::string Memory::opened() const {
    const std::lock_guard lock(mutex_);
    return opened_;
}
void Memory::set_opened(std::string toml) {
    const std::lock_guard lock(mutex_);
    opened_ = std::move(toml);
}

std::string Memory::next_own_name(const std::string& what) {
    const std::lock_guard lock(mutex_);
    return fmt::format("own-{}-{}", what, ++own_names_);
}
void Memory::set_own(std::shared_ptr<const OwnShape> shape) {
    const std::lock_guard lock(mutex_);
    own_shape_ = std::move(shape);
}
void Memory::set_own(std::shared_ptr<const OwnLight> light) {
    const std::lock_guard lock(mutex_);
    own_light_ = std::move(light);
}
void Memory::lend_own_files(Stage& stage) const {
    const std::lock_guard lock(mutex_);
    stage.own_shape = own_shape_;
    stage.own_light = own_light_;
}

std::optional<Paint> SolvedPaints::find(const std::string& toml) const {
    const std::lock_guard lock(mutex_);
    for (const auto& [text, paint] : paints_) {
        if (text == toml) return paint;
    }
    return std::nullopt;
}

void SolvedPaints::add(const std::string& toml, const Paint& paint) {
    const std::lock_guard lock(mutex_);
    std::erase_if(paints_, [&](const auto& entry) { return entry.first == toml; });
    paints_.emplace_back(toml, paint);
    if (paints_.size() > kMax) paints_.erase(paints_.begin());
}

// --------------------------------------------------------------------------------- answers

MeasureSettings settings_of(const Viewed& viewed) {
    return {.model = models::named_model(viewed.model),
            .illuminant = viewed.illuminant,
            .observer = viewed.observer};
}

Measurement standard_readings(const Paint& standard, const Viewed& viewed) {
    try {
        return standard.measure({}, settings_of(viewed)).measurement;
    } catch (const InputError&) {
        if (standard.kind() != Kind::measured_colours) throw;
        return standard.measure().measurement;
    }
}

measure::Tolerance known_limits(measure::Tolerance tolerance,
                                const measure::Difference& difference) {
    std::erase_if(tolerance.limits, [&](const auto& limit) {
        return std::ranges::none_of(difference.angles, [&](const auto& angle) {
            return angle.geometry.name == limit.first;
        });
    });
    return tolerance;
}

NamedPaint paint_of(const Tree& recipe, const Context& context) {
    std::string toml = toml_of_tree(recipe, context.memory.opened());
    if (auto known = context.solved.find(toml)) return {*std::move(known), std::move(toml)};
    Paint paint = open_text(toml, kRecipeFile);
    if (paint.kind() != Kind::recipe) throw InputError("recipe: must be a recipe");
    return {std::move(paint), std::move(toml)};
}

Frames answer(const OpenRequest& request, const Context& context) {
    const std::string file = request.name.empty() ? kRecipeFile : request.name;
    const NamedPaint named{open_text(request.toml, file), request.toml};
    if (named.paint.kind() != Kind::recipe) {
        throw InputError("toml: holds no recipe; measured colours are for a standard");
    }
    const Tree tree = tree_of_toml(request.toml, file);
    context.memory.set_opened(request.toml);
    return {{dumped(recipe_json(named, tree, context.id)), {}}};
}

Frames answer(const PaintRequest& request, const Context& context) {
    const NamedPaint named = paint_of(request.recipe, context);
    const Readings readings = named.paint.measure(request.viewed.geometries,
                                                  settings_of(request.viewed), context.progress);
    context.solved.add(named.toml, named.paint);
    const Measurement& measurement = readings.measurement;

    Tree json = {{"type", "readings"}, {"id", context.id}};
    json.update(colours_json(measurement));
    json["model"] = request.viewed.model;
    json["flop_index"] = or_null(measure::flop_index(measurement));
    json["colour_travel"] = travel_json(measurement);
    json["standard"] = nullptr;
    if (const auto standard = context.memory.standard()) {
        json["standard"] = difference_json(standard_readings(*standard, request.viewed),
                                           measurement, request.tolerance);
    }
    json["csv"] = readings.csv();
    // Colours do not wait for the picture.
    context.send("readings", {{dumped(recipe_json(named, request.recipe, context.id)), {}},
                              {dumped(json), {}}});
    Frames frames;
    if (request.shader) frames.push_back(shader_frame(named.paint, request.lamp, context));
    frames.push_back(done(context.id));
    return frames;
}

Frames answer(const FilmsRequest& request, const Context& context) {
    const Paint paint = paint_of(request.recipe, context).paint;
    const auto solved = paint.solved({}, context.progress);
    const auto films = exchange::make_live_webgl_films(*solved, context.progress);
    std::string bytes;
    Tree json = {{"type", "films"}, {"id", context.id}};
    json["uniforms"] = Tree::array({uniform_json(films.uniform)});
    json["binary"] = Tree::array({texture_json(films.texture, bytes)});
    return {{dumped(json), std::move(bytes)}};
}

Frames answer(const StandardRequest& request, const Context& context) {
    Tree json = {{"type", "standard"}, {"id", context.id}};
    if (!request.text) {
        context.memory.set_standard(nullptr);
        json["name"] = nullptr;
        return {{dumped(json), {}}};
    }
    auto standard =
        std::make_shared<const Paint>(open_text(*request.text, request.name, {}, request.sample));
    if (standard->kind() != Kind::measured_colours && standard->kind() != Kind::recipe) {
        throw InputError(request.name + ": must hold measured colours, or a recipe");
    }
    const Measurement measurement =
        standard->measure({}, {.model = models::named_model(request.model)}, context.progress)
            .measurement;
    context.memory.set_standard(standard);
    json.update(colours_json(measurement));
    json["notes"] = standard->notes();
    if (standard->kind() == Kind::measured_colours) {
        for (const std::string& line : standard->implausible_numbers())
            json["notes"].push_back(line);
    }
    return {{dumped(json), {}}};
}

Frames answer(const Message& message, const Context& context) {
    return std::visit(
        [&](const auto& request) -> Frames {
            if constexpr (requires { answer(request, context); }) {
                return answer(request, context);
            } else {
                throw InputError("type: a stop is no job");
            }
        },
        message.request);
}

}  // namespace nacre::studio
