#include "nacre/io/merl_file.h"

#include <cstdint>
#include <cstring>
#include <optional>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/byte_reader.h"
#include "nacre/io/rgl_file.h"

namespace nacre::io {

namespace {

constexpr std::size_t kHeadBytes = 3 * sizeof(std::int32_t);

struct Sides {
    std::int32_t cells[3];
    bool in_range() const {
        for (const std::int32_t n : cells) {
            if (n < bsdf::kLeastMerlCells || n > bsdf::kMostMerlCells) return false;
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
                                     name, n[0], n[1], n[2], bsdf::kLeastMerlCells,
                                     bsdf::kMostMerlCells));
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
    return parse_merl(read_file(path, kMostMeasuredBytes), path.string());
}

std::string merl_bytes(const bsdf::MerlTable& table) {
    bsdf::validate(table);
    std::string bytes;
    bytes.reserve(kHeadBytes + table.values.size() * sizeof(double));
    for (const int n : {table.half, table.difference, table.azimuths}) {
        append_number(bytes, static_cast<std::int32_t>(n));
    }
    bytes.append(reinterpret_cast<const char*>(table.values.data()),
                 table.values.size() * sizeof(double));
    return bytes;
}

void write_merl(const std::filesystem::path& path, const bsdf::MerlTable& table) {
    write_file_atomically(path, merl_bytes(table));
}

}  // namespace nacre::io
