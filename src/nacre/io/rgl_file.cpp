#include "nacre/io/rgl_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/tensor_file.h"

namespace nacre::io {

namespace {

using Shape = std::vector<std::uint64_t>;

/// More points than this per side or angle is no measurement, and would not fit an int.
constexpr std::uint64_t kMostPerAxis = 1 << 20;

// ---------------------------------------------------------------------------------- reading

class Fields {
 public:
    Fields(std::string_view bytes, const std::string& name)
        : file_(name), fields_(parse_tensor_file(bytes, name)) {}

    bool has(std::string_view name) const { return find(name) != nullptr; }

    const TensorField& get(std::string_view name, TensorType type, std::size_t rank) const {
        const TensorField* field = find(name);
        if (!field) refuse(name, "is missing");
        if (field->type != type) {
            refuse(name,
                   fmt::format("has type {}: must be {}", name_of(field->type), name_of(type)));
        }
        if (field->shape.size() != rank) {
            refuse(name, fmt::format("has rank {}: must be {}", field->shape.size(), rank));
        }
        for (const std::uint64_t n : field->shape) {
            if (n > kMostPerAxis) {
                refuse(name, fmt::format("has shape {}: at most {} in each direction",
                                         fmt::join(field->shape, " x "), kMostPerAxis));
            }
        }
        return *field;
    }

    std::vector<float> floats(std::string_view name, std::size_t rank, Shape& shape) const {
        const TensorField& field = get(name, TensorType::float32, rank);
        shape = field.shape;
        std::vector<float> values(field.bytes.size() / sizeof(float));
        if (!values.empty()) std::memcpy(values.data(), field.bytes.data(), field.bytes.size());
        return values;
    }

    /// Floats whose leading sizes are known.
    std::vector<float> floats(std::string_view name, std::size_t rank, const Shape& leading,
                              Shape& shape) const {
        std::vector<float> values = floats(name, rank, shape);
        if (!std::equal(leading.begin(), leading.end(), shape.begin())) {
            refuse(name, fmt::format("has shape {}: must begin with {}", fmt::join(shape, " x "),
                                     fmt::join(leading, " x ")));
        }
        return values;
    }

    [[noreturn]] void refuse(std::string_view name, const std::string& why) const {
        throw InputError(fmt::format("{}: field {} {}", file_, name, why));
    }

 private:
    const TensorField* find(std::string_view name) const {
        const auto found = std::find_if(fields_.begin(), fields_.end(),
                                        [&](const TensorField& f) { return f.name == name; });
        return found == fields_.end() ? nullptr : &*found;
    }

    const std::string& file_;
    std::vector<TensorField> fields_;
};

bsdf::SquareTable read_square(const Fields& fields, std::string_view name) {
    Shape shape;
    bsdf::SquareTable table;
    table.values = fields.floats(name, 2, shape);
    table.rows = static_cast<int>(shape[0]);
    table.columns = static_cast<int>(shape[1]);
    return table;
}

bool read_flag(const Fields& fields, std::string_view name) {
    const TensorField& field = fields.get(name, TensorType::uint8, 1);
    if (field.bytes != std::string(1, '\0') && field.bytes != std::string(1, '\1')) {
        fields.refuse(name, "must be one value, 0 or 1");
    }
    return field.bytes[0] != 0;
}

bsdf::RglTable read_fields(const Fields& fields) {
    bsdf::RglTable table;
    table.description = fields.get("description", TensorType::uint8, 1).bytes;
    table.jacobian = read_flag(fields, "jacobian");
    Shape shape;
    table.phi_i = fields.floats("phi_i", 1, shape);
    table.theta_i = fields.floats("theta_i", 1, shape);
    table.ndf = read_square(fields, "ndf");
    table.sigma = read_square(fields, "sigma");
    Shape leading = {table.phi_i.size(), table.theta_i.size()};
    table.vndf = fields.floats("vndf", 4, leading, shape);
    table.vndf_rows = static_cast<int>(shape[2]);
    table.vndf_columns = static_cast<int>(shape[3]);
    table.luminance = fields.floats("luminance", 4, leading, shape);
    table.resolution = static_cast<int>(shape[2]);
    const Shape square = {shape[2], shape[2]};
    if (shape[3] != shape[2]) {
        fields.refuse("luminance",
                      fmt::format("has {} x {} points: must be square", shape[2], shape[3]));
    }
    const bool spectral = fields.has("spectra") || fields.has("wavelengths");
    if (spectral && fields.has("rgb")) {
        fields.refuse("rgb", "and spectra are both there: must be one of them");
    }
    if (!spectral && !fields.has("rgb")) fields.refuse("spectra", "is missing, and so is rgb");
    if (spectral) {
        table.wavelengths = fields.floats("wavelengths", 1, shape);
        if (table.wavelengths.empty()) fields.refuse("wavelengths", "is empty");
    }
    leading.push_back(table.channels());
    leading.insert(leading.end(), square.begin(), square.end());
    table.spectra = fields.floats(spectral ? "spectra" : "rgb", 5, leading, shape);
    return table;
}

// ---------------------------------------------------------------------------------- writing

TensorField float_field(std::string name, Shape shape, const std::vector<float>& values) {
    return {
        std::move(name), TensorType::float32, std::move(shape),
        std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float))};
}

TensorField square_field(std::string name, const bsdf::SquareTable& table) {
    return float_field(
        std::move(name),
        {static_cast<std::uint64_t>(table.rows), static_cast<std::uint64_t>(table.columns)},
        table.values);
}

}  // namespace

bool looks_like_rgl(std::string_view bytes) { return looks_like_tensor_file(bytes); }

bsdf::RglTable parse_rgl(std::string_view bytes, const std::string& name) {
    bsdf::RglTable table = read_fields(Fields(bytes, name));
    try {
        bsdf::validate(table);
    } catch (const DomainError& error) {
        throw InputError(fmt::format("{}: field {}", name, error.what()));
    }
    return table;
}

bsdf::RglTable read_rgl(const std::filesystem::path& path) {
    return parse_rgl(read_file(path, kMostMeasuredBytes), path.string());
}

std::string rgl_bytes(const bsdf::RglTable& table) {
    bsdf::validate(table);
    const std::uint64_t a = table.phi_i.size(), b = table.theta_i.size(), n = table.resolution,
                        w = table.channels();
    std::vector<TensorField> fields = {
        {"description", TensorType::uint8, {table.description.size()}, table.description},
        float_field("phi_i", {a}, table.phi_i),
        float_field("theta_i", {b}, table.theta_i),
        square_field("ndf", table.ndf),
        square_field("sigma", table.sigma),
        float_field("vndf",
                    {a, b, static_cast<std::uint64_t>(table.vndf_rows),
                     static_cast<std::uint64_t>(table.vndf_columns)},
                    table.vndf),
        float_field("luminance", {a, b, n, n}, table.luminance)};
    if (!table.is_rgb()) fields.push_back(float_field("wavelengths", {w}, table.wavelengths));
    fields.push_back(
        float_field(table.is_rgb() ? "rgb" : "spectra", {a, b, w, n, n}, table.spectra));
    fields.push_back(
        {"jacobian", TensorType::uint8, {1}, std::string(1, table.jacobian ? '\1' : '\0')});
    return tensor_file_bytes(fields);
}

void write_rgl(const std::filesystem::path& path, const bsdf::RglTable& table) {
    write_file_atomically(path, rgl_bytes(table));
}

}  // namespace nacre::io
