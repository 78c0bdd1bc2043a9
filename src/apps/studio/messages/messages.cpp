#include "apps/studio/messages/messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "nacre/core/base64.h"
#include "nacre/core/text.h"
#include "nacre/fit/fit.h"
#include "nacre/io/image.h"
#include "nacre/io/table_reader.h"

namespace nacre::studio {

std::string parse_reading_model(const std::string& name, ReadingModels models) {
    const std::vector<std::string> names(models.begin(), models.end());
    if (std::ranges::find(names, name) != names.end()) return name;
    throw InputError(fmt::format("is no model by which paints are read here{}; there are: {}",
                                 did_you_mean(name, names), fmt::join(names, ", ")));
}

namespace {

/// A message's tables nest as deep as those of the recipe in it, and one more.
constexpr int kMaxMessageNesting = io::kMaxTomlNesting + 2;
/// Far more than recipes have. Objects look for their keys one by one.
constexpr std::size_t kMaxKeys = 10'000;
constexpr std::size_t kMaxNameBytes = 300;
/// Pixels of a picture: a screen's.
constexpr double kMaxPicturePixels = 4096.0 * 2160;
constexpr std::size_t kMaxGeometries = 200;  // the set "full" has 186
constexpr std::size_t kMaxAtlasValues = 200;

/// Refuses what would take long, or deep recursion, before it is parsed.
void check_structure(std::string_view text) {
    int depth = 0;
    std::size_t keys = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '\\') ++i;
            if (c == '"') quoted = false;
            continue;
        }
        if (c == '"') quoted = true;
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        if (c == ':') ++keys;
        if (depth > kMaxMessageNesting) {
            throw InputError(
                fmt::format("message: nests deeper than {} levels", kMaxMessageNesting));
        }
        if (keys > kMaxKeys) {
            throw InputError(fmt::format("message: has more than {} keys", kMaxKeys));
        }
    }
}

/// The keys of an object of a message. Each is asked for once; those that nobody asked for are
/// refused.
class Fields {
 public:
    Fields(const Tree& object, std::string path) : object_(object), path_(std::move(path)) {
        if (!object.is_object()) fail("", "must be an object");
    }

    /// Refuses the keys that are left.
    void finish() const {
        for (const auto& [key, value] : object_.items()) {
            if (known_.contains(key)) continue;
            fail(key, fmt::format("there is no such key{}; there are: {}",
                                  did_you_mean(key, std::vector(known_.begin(), known_.end())),
                                  fmt::join(known_, ", ")));
        }
    }

    /// Null if it is not there, or null.
    const Tree* find(const std::string& key) {
        known_.insert(key);
        const auto found = object_.find(key);
        return found == object_.end() || found->is_null() ? nullptr : &*found;
    }

    const Tree& object(const std::string& key) {
        const Tree* value = find(key);
        if (!value || !value->is_object()) fail(key, "must be an object");
        return *value;
    }
    std::string text(const std::string& key, const std::string& otherwise, std::size_t longest) {
        const Tree* value = find(key);
        if (!value) return otherwise;
        if (!value->is_string()) fail(key, "must be a text");
        const auto& text = value->get_ref<const std::string&>();
        if (text.size() > longest) {
            fail(key,
                 fmt::format("is {} bytes long; at most {} are allowed", text.size(), longest));
        }
        return text;
    }
    double number(const std::string& key, double otherwise, const Range& range) {
        const Tree* value = find(key);
        if (!value) return otherwise;
        const double x = value->is_number() ? value->get<double>() : std::nan("");
        if (!range.contains(x)) fail(key, "must be a number in " + range.text());
        return x;
    }
    int whole(const std::string& key, int otherwise, const Range& range) {
        const double x = number(key, otherwise, range);
        if (x != std::floor(x)) fail(key, "must be a whole number");
        return static_cast<int>(x);
    }
    bool flag(const std::string& key) {
        const Tree* value = find(key);
        if (!value) return false;
        if (!value->is_boolean()) fail(key, "must be true or false");
        return value->get<bool>();
    }
    /// Runs what throws an InputError or a DomainError about the value of a key.
    template <class Parse>
    auto parsed(const std::string& key, const Parse& parse) const {
        try {
            return parse();
        } catch (const Error& error) {
            fail(key, error.what());
        }
    }

    [[noreturn]] void fail(const std::string& key, const std::string& why) const {
        const std::string path = path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
        const auto found = object_.is_object() ? object_.find(key) : object_.end();
        std::string value;
        if (found != object_.end() && found->is_primitive()) {
            value = " = " + excerpt(found->dump(-1, ' ', false, Tree::error_handler_t::replace));
        }
        throw InputError(fmt::format("{}{}: {}", printable(excerpt(path, 200)), value, why));
    }

 private:
    const Tree& object_;
    std::string path_;
    std::set<std::string> known_;
};

spectra::Illuminant illuminant_of(Fields& fields, const char* key) {
    const std::string name = fields.text(key, "D65", kMaxNameBytes);
    return fields.parsed(key, [&] { return spectra::parse_illuminant(name); });
}

std::string reading_model_of(Fields& fields, ReadingModels models) {
    const std::string name = fields.text("model", std::string(models.front()), kMaxNameBytes);
    return fields.parsed("model", [&] { return parse_reading_model(name, models); });
}

Viewed viewed_of(Fields& fields, ReadingModels models) {
    Viewed viewed;
    const std::string set = fields.text("geometries", measure::kDefaultGeometries, 10'000);
    // Neither files nor the standard input: what is no set and no list is refused.
    viewed.geometries = fields.parsed("geometries", [&] {
        if (const auto* known = measure::find_geometry_set(set)) return known->geometries;
        if (set.empty() || set[0] < '0' || set[0] > '9' || set.ends_with(".toml")) {
            std::vector<std::string> names;
            for (const auto& known : measure::geometry_sets()) names.push_back(known.name);
            throw InputError(
                fmt::format("is no set{}; there are {}; or give a list as in 45as15,45as110",
                            did_you_mean(set, names), fmt::join(names, ", ")));
        }
        return measure::parse_geometries(set);
    });
    if (viewed.geometries.size() > kMaxGeometries) {
        fields.fail("geometries", fmt::format("at most {} are allowed", kMaxGeometries));
    }
    viewed.illuminant = illuminant_of(fields, "illuminant");
    const std::string observer = fields.text("observer", "10", kMaxNameBytes);
    viewed.observer = fields.parsed("observer", [&] { return spectra::parse_observer(observer); });
    viewed.model = reading_model_of(fields, models);
    return viewed;
}

measure::Tolerance tolerance_of(Fields& fields) {
    measure::Tolerance tolerance;
    const Tree* given = fields.find("tolerance");
    if (!given) return tolerance;
    Fields own(*given, "tolerance");
    const std::string formula = own.text("formula", tolerance.formula.name(), kMaxNameBytes);
    tolerance.formula = own.parsed("formula", [&] { return measure::parse_formula(formula); });
    if (own.find("limit")) tolerance.limit = own.number("limit", 0, measure::kToleranceLimit);
    if (own.find("limits")) {
        const Tree& limits = own.object("limits");
        Fields by_name(limits, "tolerance.limits");
        for (const auto& [name, limit] : limits.items()) {
            tolerance.limits[name] = by_name.number(name, 0, measure::kToleranceLimit);
        }
    }
    own.finish();
    return tolerance;
}

Stage stage_of(Fields& fields) {
    Stage stage;
    const Tree* given = fields.find("scene");
    if (!given) return stage;
    Fields own(*given, "scene");
    stage.shape = own.text("shape", stage.shape, kMaxNameBytes);
    stage.light = own.text("light", stage.light, kMaxNameBytes);
    stage.turn_deg = own.number("turn_deg", 0, kTurn);
    stage.light_turn_deg = own.number("light_turn_deg", 0, kTurn);
    stage.specimen = own.number("specimen", 0, {0, 1e15});
    if (const Tree* camera = own.find("camera")) {
        Fields keys(*camera, "scene.camera");
        OrbitCamera& orbit = stage.camera.emplace();
        orbit.azimuth_deg = keys.number("azimuth_deg", orbit.azimuth_deg, kTurn);
        orbit.elevation_deg = keys.number("elevation_deg", orbit.elevation_deg, kElevation);
        orbit.distance_mm = keys.number("distance_mm", orbit.distance_mm, kDistance);
        orbit.fov_deg = keys.number("fov_deg", orbit.fov_deg, kFieldOfView);
        keys.finish();
    }
    own.finish();
    return stage;
}

/// For messages; only what follows its last dot decides anything.
std::string file_name_of(Fields& fields) {
    const std::string name = fields.text("file", "", kMaxNameBytes);
    if (name.empty()) fields.fail("file", "is missing: the name of the file");
    return printable(name);
}

std::string bytes_of(Fields& fields) {
    const auto bytes = from_base64(fields.text("base64", "", kMaxMessageBytes));
    if (!bytes) fields.fail("base64", "must be the bytes of the file as base64, with padding");
    return *bytes;
}

RenderRequest render_of(Fields& fields) {
    const Range kSide{1, io::kMaxPixelsPerSide, "pixels"};
    RenderRequest request;
    request.recipe = fields.object("recipe");
    request.stage = stage_of(fields);
    request.width = fields.whole("width", request.width, kSide);
    request.height = fields.whole("height", request.height, kSide);
    if (static_cast<double>(request.width) * request.height > kMaxPicturePixels) {
        fields.fail("width", fmt::format("times height must be at most {}", kMaxPicturePixels));
    }
    request.samples = fields.whole("samples", request.samples, {1, 1 << 16});
    request.model = fields.text("model", "", kMaxNameBytes);
    request.linear = fields.flag("linear");
    return request;
}

Request request_of(const std::string& type, Fields& fields, ReadingModels models) {
    if (type == "open") {
        const Tree* toml = fields.find("toml");
        if (!toml) fields.fail("toml", "is missing");
        return OpenRequest{fields.text("toml", "", io::kMaxTextBytes),
                           printable(fields.text("name", "", kMaxNameBytes))};
    }
    if (type == "paint") {
        return PaintRequest{fields.object("recipe"), viewed_of(fields, models),
                            fields.flag("shader"), illuminant_of(fields, "lamp"),
                            tolerance_of(fields)};
    }
    if (type == "films") return FilmsRequest{fields.object("recipe")};
    if (type == "standard") {
        StandardRequest request;
        if (fields.find("csv")) request.text = fields.text("csv", "", kMaxMessageBytes);
        request.name = fields.text("name", "standard", kMaxNameBytes);
        request.sample = fields.text("sample", "", kMaxNameBytes);
        request.model = reading_model_of(fields, models);
        return request;
    }
    if (type == "sparkle") {
        return SparkleRequest{fields.object("recipe"), fields.number("specimen", 0, {0, 1e15})};
    }
    if (type == "fit") {
        FitRequest request;
        request.recipe = fields.object("recipe");
        if (const Tree* free = fields.find("free")) {
            if (!free->is_array()) fields.fail("free", "must be a list of keys");
            for (const Tree& key : *free) {
                if (!key.is_string()) fields.fail("free", "must be a list of keys");
                request.free.push_back(key.get<std::string>());
            }
            if (request.free.size() > fit::FreeNumbers::kMax) {
                fields.fail("free", fmt::format("has {} keys; at most {} are allowed",
                                                request.free.size(), fit::FreeNumbers::kMax));
            }
        }
        request.starts = fields.whole("starts", request.starts, {1, fit::FitOptions::kMaxStarts});
        request.model = reading_model_of(fields, models);
        return request;
    }
    if (type == "stop") {
        StopRequest request;
        if (fields.find("what")) request.type = fields.text("what", "", kMaxNameBytes);
        return request;
    }
    if (type == "render") return render_of(fields);
    if (type == "report") {
        ReportRequest request;
        request.recipe = fields.object("recipe");
        request.viewed = viewed_of(fields, models);
        request.tolerance = tolerance_of(fields);
        request.draft = fields.flag("draft");
        return request;
    }
    if (type == "atlas") {
        AtlasRequest request;
        request.recipe = fields.object("recipe");
        request.key = fields.text("key", "", kMaxNameBytes);
        const Tree* values = fields.find("values");
        const bool numbers = values && values->is_array() && !values->empty() &&
                             values->size() <= kMaxAtlasValues &&
                             std::ranges::all_of(*values, &Tree::is_number);
        if (!numbers) {
            fields.fail("values",
                        fmt::format("must be a list of 1 to {} numbers", kMaxAtlasValues));
        }
        request.values = values->get<std::vector<double>>();
        request.viewed = viewed_of(fields, models);
        return request;
    }
    if (type == "shape") {
        return ShapeRequest{file_name_of(fields), bytes_of(fields), fields.flag("y_up")};
    }
    if (type == "light") return LightRequest{file_name_of(fields), bytes_of(fields)};
    static const std::vector<std::string> kTypes = {"open",    "paint", "films", "standard",
                                                    "sparkle", "fit",   "stop",  "render",
                                                    "report",  "atlas", "shape", "light"};
    fields.fail("type", fmt::format("there is no such message{}; there are: {}",
                                    did_you_mean(type, kTypes), fmt::join(kTypes, ", ")));
}

}  // namespace

Message parse_message(std::string_view text, ReadingModels models) {
    Message message;
    try {
        check_structure(text);
        const Tree tree = Tree::parse(text);
        Fields fields(tree, "");
        if (const Tree* id = fields.find("id")) {
            const bool is_id = id->is_number() || (id->is_string() && id->dump().size() < 100);
            if (!is_id) fields.fail("id", "must be a number, or a text of at most 100 bytes");
            message.id = *id;
        }
        message.type = fields.text("type", "", kMaxNameBytes);
        message.request = request_of(message.type, fields, models);
        fields.finish();
    } catch (const InputError& error) {
        throw MessageError(error.what(), message.id);
    } catch (const Tree::exception& error) {
        throw MessageError(
            fmt::format("message: is not JSON: {}", printable(excerpt(error.what(), 200))),
            message.id);
    }
    return message;
}

}  // namespace nacre::studio
