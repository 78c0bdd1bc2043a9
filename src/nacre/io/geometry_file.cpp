#include "nacre/io/geometry_file.h"

#include <fmt/format.h>

#include <set>
#include <tuple>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/table_reader.h"

namespace nacre::io {

namespace {

constexpr std::size_t kMaxNameLength = 100, kMaxSummaryLength = 1000;

measure::Geometry read_directions(const TableReader& table) {
    constexpr Range kPolar{0, 90, "deg", false, true}, kAspecular{-180, 180, "deg"},
        kTurn{-360, 360, "deg"};
    const double lamp_deg = table.number("lamp_deg", kPolar);
    if (table.has("view_deg")) {
        if (table.has("aspecular_deg") || table.has("azimuth_deg")) {
            table.fail("view_deg",
                       "stands for the view by itself, without aspecular_deg and "
                       "azimuth_deg");
        }
        const std::vector<double> view = table.numbers("view_deg", kTurn, 2, 2);
        return measure::towards(lamp_deg, view[0], view[1]);
    }
    const double aspecular_deg = table.number("aspecular_deg", kAspecular);
    if (!table.has("azimuth_deg")) return measure::in_plane(lamp_deg, aspecular_deg);
    return measure::off_plane(lamp_deg, aspecular_deg,
                              table.number("azimuth_deg", {-180, 180, "deg"}));
}

measure::Geometry read_geometry(const TableReader& table) {
    try {
        measure::Geometry geometry = read_directions(table);
        geometry.name = table.text_or("name", geometry.name, kMaxNameLength);
        if (geometry.name.empty()) table.fail("name", "must not be empty");
        return geometry;
    } catch (const DomainError& error) {
        table.fail(error.what());
    }
}

measure::GeometrySet read_geometries(TomlDocument& document) {
    const TableReader root(document, {"name", "summary", "geometry"});
    measure::GeometrySet set{root.text_or("name", document.filename(), kMaxNameLength),
                             root.text_or("summary", "", kMaxSummaryLength),
                             {}};
    std::set<std::string> names;
    std::set<std::tuple<double, double, double>> directions;
    for (const TableReader& table :
         root.tables("geometry", kMaxGeometries,
                     {"name", "lamp_deg", "aspecular_deg", "azimuth_deg", "view_deg"})) {
        set.geometries.push_back(read_geometry(table));
        const std::string& name = set.geometries.back().name;
        if (!names.insert(name).second) {
            table.fail(fmt::format("'{}' stands in this set already", name));
        }
        // A file of readings names each direction once.
        const measure::Geometry& g = set.geometries.back();
        if (!directions.insert({g.theta_i_deg, g.theta_o_deg, g.phi_deg}).second) {
            table.fail(fmt::format("the direction of '{}' stands in this set already", name));
        }
    }
    if (set.geometries.empty()) {
        root.fail("geometry", "is missing; a set needs at least one [[geometry]]");
    }
    return set;
}

}  // namespace

measure::GeometrySet parse_geometry_set(std::string_view text, const std::string& filename) {
    TomlDocument document(text, filename, {});
    return read_geometries(document);
}

measure::GeometrySet parse_geometry_set(const TypedFile& file) {
    return read_geometries(*TomlDocument::of(file));
}

measure::GeometrySet read_geometry_set(const std::filesystem::path& path) {
    return parse_geometry_set(read_file(path, kMaxTextBytes), path.string());
}

}  // namespace nacre::io
