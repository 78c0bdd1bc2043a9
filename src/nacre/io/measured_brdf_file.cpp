#include "nacre/io/measured_brdf_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/file.h"

namespace nacre::io {

namespace {

constexpr std::string_view kTensorFileMagic("tensor_file\0", 12);
constexpr std::uint8_t kMajor = 1, kMinor = 0;
constexpr std::size_t kAlignment = 8;

struct TypeInfo {
    std::string_view name;
    std::size_t bytes;
};
constexpr std::array<TypeInfo, 11> kTypes = {{{"uint8", 1},
                                              {"int8", 1},
                                              {"uint16", 2},
                                              {"int16", 2},
                                              {"uint32", 4},
                                              {"int32", 4},
                                              {"uint64", 8},
                                              {"int64", 8},
                                              {"float16", 2},
                                              {"float32", 4},
                                              {"float64", 8}}};

const TypeInfo& info(TensorType type) { return kTypes.at(static_cast<std::size_t>(type) - 1); }

/// Reads the list of fields with messages that say where it went wrong.
class Parser {
 public:
    Parser(std::string_view bytes, const std::string& name)
        : bytes_(bytes), file_(name), reader_(bytes) {}

    std::vector<TensorField> fields() {
        if (!looks_like_tensor_file(bytes_)) refuse("", "is not a tensor file (.bsdf)");
        reader_.take_bytes(kTensorFileMagic.size());
        const auto major = number<std::uint8_t>(""), minor = number<std::uint8_t>("");
        if (major != kMajor || minor != kMinor) {
            refuse("", fmt::format("has version {}.{} of the format: must be {}.{}", major, minor,
                                   kMajor, kMinor));
        }
        const auto count = number<std::uint32_t>("");
        if (count > kMaxTensorFields) {
            refuse("", fmt::format("has {} fields: must be at most {}", count, kMaxTensorFields));
        }
        std::vector<TensorField> fields;
        for (std::uint32_t i = 0; i < count; ++i) {
            fields.push_back(field(fmt::format("field {}", i)));
            const auto same = [&](const TensorField& f) { return f.name == fields.back().name; };
            if (std::count_if(fields.begin(), fields.end(), same) > 1) {
                refuse(fields.back().name, "is there twice");
            }
        }
        return fields;
    }

 private:
    [[noreturn]] void refuse(const std::string& where, const std::string& why) const {
        throw InputError(fmt::format("{}: {}{}{}", file_, where, where.empty() ? "" : " ", why));
    }
    template <class T>
    T number(const std::string& where) {
        if (const auto value = reader_.take<T>()) return *value;
        refuse(where, "is cut short");
    }

    TensorField field(const std::string& where) {
        TensorField field;
        const auto length = number<std::uint16_t>(where);
        const auto name = reader_.take_bytes(length);
        if (!name) refuse(where, "is cut short");
        const auto printable = [](char c) { return c > ' ' && c <= '~'; };
        if (name->empty() || !std::all_of(name->begin(), name->end(), printable)) {
            refuse(where, "has a name that is empty or not printable ASCII");
        }
        field.name = *name;
        const auto rank = number<std::uint16_t>(field.name);
        if (rank > kMaxTensorRank) {
            refuse(field.name,
                   fmt::format("has rank {}: must be at most {}", rank, kMaxTensorRank));
        }
        const auto type = number<std::uint8_t>(field.name);
        if (type < 1 || type > kTypes.size()) {
            refuse(field.name, fmt::format("has type {}: must be in [1, {}]", type, kTypes.size()));
        }
        field.type = static_cast<TensorType>(type);
        const auto offset = number<std::uint64_t>(field.name);
        std::uint64_t size = bytes_of(field.type);
        for (int k = 0; k < rank; ++k) {
            field.shape.push_back(number<std::uint64_t>(field.name));
            // No product of sizes may pass what the file holds, nor 64 bits.
            const std::uint64_t n = field.shape.back();
            if (n != 0 && size > bytes_.size() / n) {
                refuse(field.name, fmt::format("has more values ({}) than the file has bytes ({})",
                                               fmt::join(field.shape, " x "), bytes_.size()));
            }
            size *= n;
        }
        if (offset > bytes_.size() || size > bytes_.size() - offset) {
            refuse(field.name, fmt::format("has {} bytes from {} on: the file ends at {}", size,
                                           offset, bytes_.size()));
        }
        field.bytes = bytes_.substr(offset, size);
        total_ += size;
        if (total_ > bytes_.size()) refuse(field.name, "shares its bytes with other fields");
        return field;
    }

    std::string_view bytes_;
    const std::string& file_;
    ByteReader reader_;
    std::uint64_t total_ = 0;
};

}  // namespace

std::size_t bytes_of(TensorType type) { return info(type).bytes; }
std::string_view name_of(TensorType type) { return info(type).name; }

bool looks_like_tensor_file(std::string_view bytes) { return bytes.starts_with(kTensorFileMagic); }

std::vector<TensorField> parse_tensor_file(std::string_view bytes, const std::string& name) {
    return Parser(bytes, name).fields();
}

namespace {

std::size_t aligned(std::size_t position) {
    return (position + kAlignment - 1) / kAlignment * kAlignment;
}

/// Appends a gigabyte piece by piece, so that whoever waits for it may give up.
void append_bytes(std::string& to, std::string_view bytes, SharedProgress* work) {
    constexpr std::size_t kPiece = 1 << 24;
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
        if (work) work->throw_if_stopped("making the file");
        to.append(bytes.substr(at, kPiece));
    }
}

}  // namespace

std::string tensor_file_bytes(const std::vector<TensorField>& fields, SharedProgress* work) {
    require_in_range(static_cast<double>(fields.size()), 0, kMaxTensorFields, "number of fields");
    std::size_t position = kTensorFileMagic.size() + 2 + sizeof(std::uint32_t);
    for (const TensorField& field : fields) {
        std::uint64_t size = bytes_of(field.type);
        for (const std::uint64_t n : field.shape) size *= n;
        if (size != field.bytes.size() || field.shape.size() > kMaxTensorRank ||
            field.name.empty() || field.name.size() > 255) {
            throw DomainError(fmt::format("field '{}' has {} bytes, its shape {} wants {}",
                                          field.name, field.bytes.size(),
                                          fmt::join(field.shape, " x "), size));
        }
        position += 2 + field.name.size() + 2 + 1 + 8 + 8 * field.shape.size();
    }
    std::string head(kTensorFileMagic);
    append_number(head, kMajor);
    append_number(head, kMinor);
    append_number(head, static_cast<std::uint32_t>(fields.size()));
    for (const TensorField& field : fields) {
        position = aligned(position);
        append_number(head, static_cast<std::uint16_t>(field.name.size()));
        head += field.name;
        append_number(head, static_cast<std::uint16_t>(field.shape.size()));
        append_number(head, static_cast<std::uint8_t>(field.type));
        append_number(head, static_cast<std::uint64_t>(position));
        for (const std::uint64_t n : field.shape) append_number(head, n);
        position += field.bytes.size();
    }
    std::string bytes;
    bytes.reserve(position);
    bytes += head;
    for (const TensorField& field : fields) {
        bytes.resize(aligned(bytes.size()), '\0');
        append_bytes(bytes, field.bytes, work);
    }
    return bytes;
}

namespace {

using Shape = std::vector<std::uint64_t>;

/// More points than this per side or angle is no measurement, and would not fit an int.
constexpr std::uint64_t kMaxPerAxis = 1 << 20;

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
            if (n > kMaxPerAxis) {
                refuse(name, fmt::format("has shape {}: at most {} in each direction",
                                         fmt::join(field->shape, " x "), kMaxPerAxis));
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

/// The bytes of an array as it lies in memory.
template <class T>
std::string_view bytes_of_array(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

TensorField float_field(std::string name, Shape shape, const std::vector<float>& values,
                        SharedProgress& work) {
    TensorField field{std::move(name), TensorType::float32, std::move(shape), {}};
    field.bytes.reserve(values.size() * sizeof(float));
    append_bytes(field.bytes, bytes_of_array(values), &work);
    return field;
}

TensorField square_field(std::string name, const bsdf::SquareTable& table, SharedProgress& work) {
    return float_field(
        std::move(name),
        {static_cast<std::uint64_t>(table.rows), static_cast<std::uint64_t>(table.columns)},
        table.values, work);
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
    return parse_rgl(read_file(path, kMaxMeasuredBytes), path.string());
}

std::string rgl_bytes(const bsdf::RglTable& table, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    bsdf::validate(table);
    const std::uint64_t a = table.phi_i.size(), b = table.theta_i.size(), n = table.resolution,
                        w = table.channels();
    std::vector<TensorField> fields = {
        {"description", TensorType::uint8, {table.description.size()}, table.description},
        float_field("phi_i", {a}, table.phi_i, work),
        float_field("theta_i", {b}, table.theta_i, work),
        square_field("ndf", table.ndf, work),
        square_field("sigma", table.sigma, work),
        float_field("vndf",
                    {a, b, static_cast<std::uint64_t>(table.vndf_rows),
                     static_cast<std::uint64_t>(table.vndf_columns)},
                    table.vndf, work),
        float_field("luminance", {a, b, n, n}, table.luminance, work)};
    if (!table.is_rgb()) fields.push_back(float_field("wavelengths", {w}, table.wavelengths, work));
    fields.push_back(
        float_field(table.is_rgb() ? "rgb" : "spectra", {a, b, w, n, n}, table.spectra, work));
    fields.push_back(
        {"jacobian", TensorType::uint8, {1}, std::string(1, table.jacobian ? '\1' : '\0')});
    return tensor_file_bytes(fields, &work);
}

void write_rgl(const std::filesystem::path& path, const bsdf::RglTable& table) {
    write_file_atomically(path, rgl_bytes(table));
}

namespace {

constexpr std::size_t kHeadBytes = 3 * sizeof(std::int32_t);

struct Sides {
    std::int32_t cells[3];
    bool in_range() const {
        for (const std::int32_t n : cells) {
            if (n < bsdf::kMinMerlCells || n > bsdf::kMaxMerlCells) return false;
        }
        return true;
    }
    /// Of the whole file; sizes in range cannot overflow it.
    std::size_t bytes() const {
        std::size_t size = 3 * sizeof(double);
        for (const std::int32_t n : cells) size *= static_cast<std::size_t>(n);
        return kHeadBytes + size;
    }
};

std::optional<Sides> read_sides(std::string_view bytes) {
    ByteReader reader(bytes);
    Sides sides;
    for (std::int32_t& n : sides.cells) {
        const auto value = reader.take<std::int32_t>();
        if (!value) return std::nullopt;
        n = *value;
    }
    return sides;
}

}  // namespace

bool looks_like_merl(std::string_view bytes) {
    const std::optional<Sides> sides = read_sides(bytes);
    return sides && sides->in_range() && sides->bytes() == bytes.size();
}

bsdf::MerlTable parse_merl(std::string_view bytes, const std::string& name) {
    const std::optional<Sides> sides = read_sides(bytes);
    if (!sides) throw InputError(fmt::format("{}: is cut short: no MERL file", name));
    const auto& n = sides->cells;
    if (!sides->in_range()) {
        throw InputError(fmt::format("{}: has {} x {} x {} cells: must have {} to {} along each",
                                     name, n[0], n[1], n[2], bsdf::kMinMerlCells,
                                     bsdf::kMaxMerlCells));
    }
    if (sides->bytes() != bytes.size()) {
        throw InputError(fmt::format("{}: has {} bytes: {} x {} x {} cells must have {}", name,
                                     bytes.size(), n[0], n[1], n[2], sides->bytes()));
    }
    bsdf::MerlTable table{n[0], n[1], n[2], {}};
    table.values.resize(3 * table.cells());
    std::memcpy(table.values.data(), bytes.data() + kHeadBytes, bytes.size() - kHeadBytes);
    try {
        bsdf::validate(table);
    } catch (const DomainError& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
    return table;
}

bsdf::MerlTable read_merl(const std::filesystem::path& path) {
    return parse_merl(read_file(path, kMaxMeasuredBytes), path.string());
}

std::string merl_bytes(const bsdf::MerlTable& table, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    bsdf::validate(table);
    std::string bytes;
    bytes.reserve(kHeadBytes + table.values.size() * sizeof(double));
    for (const int n : {table.half, table.difference, table.azimuths}) {
        append_number(bytes, static_cast<std::int32_t>(n));
    }
    append_bytes(bytes, bytes_of_array(table.values), &work);
    return bytes;
}

void write_merl(const std::filesystem::path& path, const bsdf::MerlTable& table) {
    write_file_atomically(path, merl_bytes(table));
}

}  // namespace nacre::io
