#include "nacre/io/tensor_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "nacre/core/error.h"
#include "nacre/io/byte_reader.h"

namespace nacre::io {

namespace {

constexpr std::string_view kMagic("tensor_file\0", 12);
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
        reader_.take_bytes(kMagic.size());
        const auto major = number<std::uint8_t>(""), minor = number<std::uint8_t>("");
        if (major != kMajor || minor != kMinor) {
            refuse("", fmt::format("has version {}.{} of the format: must be {}.{}", major, minor,
                                   kMajor, kMinor));
        }
        const auto count = number<std::uint32_t>("");
        if (count > kMostTensorFields) {
            refuse("", fmt::format("has {} fields: must be at most {}", count, kMostTensorFields));
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
        if (rank > kMostTensorRank) {
            refuse(field.name,
                   fmt::format("has rank {}: must be at most {}", rank, kMostTensorRank));
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

bool looks_like_tensor_file(std::string_view bytes) { return bytes.starts_with(kMagic); }

std::vector<TensorField> parse_tensor_file(std::string_view bytes, const std::string& name) {
    return Parser(bytes, name).fields();
}

std::string tensor_file_bytes(const std::vector<TensorField>& fields) {
    require_in_range(static_cast<double>(fields.size()), 0, kMostTensorFields, "number of fields");
    std::size_t position = kMagic.size() + 2 + sizeof(std::uint32_t);
    for (const TensorField& field : fields) {
        std::uint64_t size = bytes_of(field.type);
        for (const std::uint64_t n : field.shape) size *= n;
        if (size != field.bytes.size() || field.shape.size() > kMostTensorRank ||
            field.name.empty() || field.name.size() > 255) {
            throw DomainError(fmt::format("field '{}' has {} bytes, its shape {} wants {}",
                                          field.name, field.bytes.size(),
                                          fmt::join(field.shape, " x "), size));
        }
        position += 2 + field.name.size() + 2 + 1 + 8 + 8 * field.shape.size();
    }
    std::string head(kMagic), body;
    append_number(head, kMajor);
    append_number(head, kMinor);
    append_number(head, static_cast<std::uint32_t>(fields.size()));
    for (const TensorField& field : fields) {
        const std::size_t here = position + body.size();
        body.append((kAlignment - here % kAlignment) % kAlignment, '\0');
        append_number(head, static_cast<std::uint16_t>(field.name.size()));
        head += field.name;
        append_number(head, static_cast<std::uint16_t>(field.shape.size()));
        append_number(head, static_cast<std::uint8_t>(field.type));
        append_number(head, static_cast<std::uint64_t>(position + body.size()));
        for (const std::uint64_t n : field.shape) append_number(head, n);
        body += field.bytes;
    }
    return head + body;
}

}  // namespace nacre::io
