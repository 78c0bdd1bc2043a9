#include "nacre/io/brdf_table_file.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/hdf5_file.h"

namespace nacre::io {

namespace {

using bsdf::BrdfGrid;
using bsdf::BrdfTableSettings;
using bsdf::CompressedBrdfTable;
using bsdf::RawBrdfTable;

constexpr SealedFormat kBrdfTableFormat = {"nacre BRDF table", kBrdfTableFormatVersion,
                                           "BRDF table"};

// ---------------------------------------------------------------------------------- writing

void write_head(hid_t file, const std::string& paint, const BrdfGrid& grid, const char* kind) {
    write_attribute(file, "paint", paint);
    write_attribute(file, "kind", std::string(kind));
    write_attribute(file, "colour",
                    std::string("linear Rec. 709 under D65, 2 degree observer, white = (1, 1, 1)"));
    const Hdf5Handle group =
        write_group(file, "grid",
                    "f = g t_i t_o / (ior^2 (mu_i + mu_o)) with Fresnel transmittances t and "
                    "cosines mu inside; roughness > 0: f = g / (mu_i + mu_o), cosines outside. "
                    "Polar nodes even in tan(theta/2), azimuths in sqrt(ln(1 + b v^2/a^2)/"
                    "ln(1 + b/a^2)), v = sin of half the azimuth from the mirror side, "
                    "b = 4 s_i s_o/(mu_i + mu_o)^2, a = lobe_alpha");
    write_attribute(group, "angles", grid.angles);
    write_attribute(group, "azimuths", grid.azimuths);
    write_attribute(group, "ior", grid.ior);
    write_attribute(group, "roughness", grid.roughness);
    write_attribute(group, "lobe_alpha", grid.lobe_alpha);
    std::vector<double> theta;
    for (int i = 0; i < grid.angles; ++i) theta.push_back(grid.angle(i));
    write_array(file, "theta", {theta.size()}, theta.data(), "rad",
                "polar nodes outside the coat, incident and outgoing");
}

// ---------------------------------------------------------------------------------- reading

BrdfGrid read_grid(hid_t file) {
    const Hdf5Handle group(H5Gopen2(file, "grid", H5P_DEFAULT), "open group grid");
    BrdfGrid grid;
    grid.angles = read_int_attribute(group, "angles");
    grid.azimuths = read_int_attribute(group, "azimuths");
    grid.ior = read_double_attribute(group, "ior");
    grid.roughness = read_double_attribute(group, "roughness");
    grid.lobe_alpha = read_double_attribute(group, "lobe_alpha");
    validate(grid);
    return grid;
}

std::vector<float> read_exactly(hid_t file, const char* name, const Hdf5Shape& shape) {
    std::size_t max_values = 1;  // a black table has no terms, but its other sizes must pass
    for (hsize_t n : shape) max_values *= std::max<hsize_t>(n, 1);
    require_content(array_shape(file, name, shape.size(), max_values) == shape,
                    "the sizes of the arrays do not fit the grid");
    std::vector<float> values = read_floats(file, name, shape.size(), max_values);
    require_finite(values, "a value is not finite");
    return values;
}

BrdfTable read_contents(hid_t file) {
    const std::string paint = read_text_attribute(file, "paint");
    const std::string kind = read_text_attribute(file, "kind");
    const BrdfGrid grid = read_grid(file);
    const hsize_t n = grid.angles, m = grid.azimuths;
    if (kind == "raw") {
        return RawBrdfTable{paint, grid, read_exactly(file, "values", {n, n, m, 3})};
    }
    require_content(kind == "svd", "attribute kind is neither raw nor svd");
    CompressedBrdfTable table{paint, grid, {}, {}, {}};
    const std::vector<int> rank = read_ints(file, "rank", 1, 3);
    require_content(rank.size() == 3, "there are not three channels");
    for (int c = 0; c < 3; ++c) {
        require_content(rank[c] >= 0 && rank[c] <= CompressedBrdfTable::kMaxTerms,
                        "the number of terms of a channel is out of range");
        table.rank[c] = rank[c];
    }
    const hsize_t terms = table.terms();
    table.left = read_exactly(file, "left", {n, n, terms});
    table.right = read_exactly(file, "right", {m, terms});
    return table;
}

}  // namespace

bool looks_like_brdf_table(std::string_view bytes) { return is_sealed_as(kBrdfTableFormat, bytes); }

std::string brdf_table_bytes(const RawBrdfTable& table, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    return sealed_bytes(kBrdfTableFormat, [&](hid_t file) {
        write_head(file, table.paint, table.grid, "raw");
        const hsize_t n = table.grid.angles, m = table.grid.azimuths;
        write_array(file, "values", {n, n, m, 3}, table.values.data(), "1/sr",
                    "g by incident and outgoing node, azimuth and channel", &work);
    });
}

std::string brdf_table_bytes(const CompressedBrdfTable& table, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    return sealed_bytes(kBrdfTableFormat, [&](hid_t file) {
        write_head(file, table.paint, table.grid, "svd");
        const hsize_t n = table.grid.angles, m = table.grid.azimuths, terms = table.terms();
        write_array(file, "rank", {3}, table.rank.data(), "1",
                    "terms of red, green and blue; 0: the channel is zero");
        write_array(file, "left", {n, n, terms}, table.left.data(), "1/sr",
                    "g = sum over the terms of a channel of left times right", &work);
        write_array(file, "right", {m, terms}, table.right.data(), "1",
                    "right singular vectors by azimuth, the terms of a channel side by side");
    });
}

void write_brdf_table(const std::filesystem::path& path, const RawBrdfTable& table) {
    write_file_atomically(path, brdf_table_bytes(table));
}

void write_brdf_table(const std::filesystem::path& path, const CompressedBrdfTable& table) {
    write_file_atomically(path, brdf_table_bytes(table));
}

BrdfTable parse_brdf_table(std::string_view bytes, const std::string& name) {
    BrdfTable table;
    read_sealed(kBrdfTableFormat, bytes, name, [&](hid_t file) { table = read_contents(file); });
    return table;
}

BrdfTable read_brdf_table(const std::filesystem::path& path) {
    return parse_brdf_table(read_file(path, kMaxBrdfTableBytes), path.string());
}

}  // namespace nacre::io
