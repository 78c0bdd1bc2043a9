#include "nacre/io/solved_paint_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/hdf5_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/table_reader.h"

namespace nacre::io {

namespace {

constexpr SealedFormat kSolvedPaintFormat = {"nacre solved paint", kSolvedPaintFormatVersion,
                                             "solved paint"};
constexpr std::size_t kMaxWavelengths = 10'000;
constexpr std::size_t kMaxCoefficients = std::size_t{1} << 26;
constexpr std::size_t kMaxAzimuthalOrders = 65'536;
constexpr std::size_t kMaxExitNodes = 4'096;
constexpr double kMaxLobeWidth = 100;  // of a sine: wider ones are as flat as none

// ---------------------------------------------------------------------------------- writing

void write_settings(hid_t file, const solver::SolverSettings& settings) {
    const Hdf5Handle group =
        write_group(file, "settings", "how finely to solve; 0: chosen from the recipe");
    write_attribute(group, "exit_nodes", settings.exit_nodes);
    write_attribute(group, "inner_nodes", settings.inner_nodes);
    write_attribute(group, "most_orders", settings.max_orders);
    write_attribute(group, "tolerance", settings.tolerance);
}

void write_solver_report(hid_t file, const solver::SolverReport& report) {
    const Hdf5Handle group = write_group(file, "report", "what the solver found out about itself");
    write_attribute(group, "exit_nodes", report.exit_nodes);
    write_attribute(group, "inner_nodes", report.inner_nodes);
    write_attribute(group, "orders", report.orders);
    write_attribute(group, "unresolved_scattering", report.unresolved_scattering);
    write_attribute(group, "azimuthal_tail", report.azimuthal_tail);
}

/// The HDF5 group of a tensor, and the beginning of its attribute "meaning".
struct TensorGroup {
    const char* name;
    const char* meaning;
};
constexpr TensorGroup kMultipleScattering = {
    "remainder", "multiple scattering, without its Fresnel factors if the interface is smooth"};
constexpr TensorGroup kRoughSingle = {"rough_single", "single scattering under a rough interface"};

void write_tensor(hid_t file, const TensorGroup& where, const solver::MultipleScattering& r) {
    const std::string meaning = fmt::format(
        "{}: f(theta_i, theta_o, phi; wavelength) = sum_l (2 - delta_l0) cos(l (phi - pi)) sum_k "
        "basis[k][wavelength] coefficient[k][pair(l, i, j)]; pairs by order l, then rows i >= j "
        "from node first[l]; phi = phi_o - phi_i. If there is an attribute lobe_width, values "
        "between nodes come from those over exp(-((sin theta_i - sin theta_o)/lobe_width)^2) + {}",
        where.meaning, solver::kLobeFloor);
    const Hdf5Handle group = write_group(file, where.name, meaning.c_str());
    const auto size = [](const auto& v) { return static_cast<hsize_t>(v.size()); };
    const hsize_t rank = static_cast<hsize_t>(r.rank());
    const hsize_t pairs = rank > 0 ? size(r.coefficient) / rank : 0;
    if (r.lobe_width > 0) write_attribute(group, "lobe_width", r.lobe_width);
    write_attribute(group, "table_rank", r.table_rank);
    write_array(group, "exit_angle", {size(r.exit_angle)}, r.exit_angle.data(), "rad",
                "polar angles outside the coat of the nodes i and j");
    write_array(group, "first", {size(r.first)}, r.first.data(), "1",
                "by azimuthal order l: the first node with a coefficient");
    write_array(group, "basis", {rank, static_cast<hsize_t>(r.wavelength_count)}, r.basis.data(),
                "1", "spectral basis by component k and wavelength");
    write_array(group, "coefficient", {rank, pairs}, r.coefficient.data(), "1/sr",
                "by component k and pair of nodes");
}

/// The recipe as text, materials from a user's files written out by their samples. It is read back
/// at once: those files may hold more samples than a recipe may.
std::string kept_recipe(const paint::Recipe& recipe) {
    std::string text = write_recipe(recipe);
    try {
        parse_recipe(text, "recipe", "");
    } catch (const InputError& error) {
        throw Error(fmt::format("a solved file cannot keep this paint: {}", error.what()));
    }
    return text;
}

// ---------------------------------------------------------------------------------- reading

solver::MultipleScattering read_tensor(hid_t file, const TensorGroup& where,
                                       std::size_t wavelengths) {
    const Hdf5Handle group(H5Gopen2(file, where.name, H5P_DEFAULT),
                           fmt::format("open group {}", where.name));
    solver::MultipleScattering r;
    r.wavelength_count = static_cast<int>(wavelengths);
    r.exit_angle = read_doubles(group, "exit_angle", 1, kMaxExitNodes);
    r.first = read_ints(group, "first", 1, kMaxAzimuthalOrders);
    r.basis = read_floats(group, "basis", 2, wavelengths * wavelengths);
    r.coefficient = read_floats(group, "coefficient", 2, kMaxCoefficients);
    if (H5Aexists(group, "lobe_width") > 0) {  // files of older versions have none
        r.lobe_width = read_double_attribute(group, "lobe_width");
    }
    require_content(r.lobe_width >= 0 && r.lobe_width <= kMaxLobeWidth,
                    "the width of the lobe is out of range");
    r.table_rank =
        H5Aexists(group, "table_rank") > 0 ? read_int_attribute(group, "table_rank") : r.rank();
    require_content(r.table_rank >= 0 && r.table_rank <= r.rank(),
                    "the rank of tables is out of range");
    require_finite(r.exit_angle, "an exit angle is not finite");
    require_finite(r.basis, "a spectral basis is not finite");
    require_finite(r.coefficient, "a coefficient is not finite");

    const int nodes = static_cast<int>(r.exit_angle.size());
    require_content(nodes > 0, "there are no exit angles");
    for (int i = 0; i < nodes; ++i) {
        require_content(r.exit_angle[i] >= (i ? r.exit_angle[i - 1] : 0.0) &&
                            r.exit_angle[i] <= std::numbers::pi / 2,
                        "exit angles must increase within [0, pi/2]");
    }
    for (int first : r.first)
        require_content(first >= 0 && first <= nodes, "a first node is out of range");
    const Hdf5Shape basis = array_shape(group, "basis", 2, wavelengths * wavelengths);
    const Hdf5Shape coefficient = array_shape(group, "coefficient", 2, kMaxCoefficients);
    require_content(basis[1] == wavelengths && coefficient[0] == basis[0] &&
                        coefficient[1] == (basis[0] ? r.pair_count() : 0),
                    "the sizes of the arrays do not fit together");
    return r;
}

solver::SolvedPaint read_contents(hid_t file, const std::string& name) {
    const std::string recipe = read_text(file, "recipe", kMaxTextBytes);
    const std::vector<double> wavelengths =
        read_doubles(file, "wavelengths_nm", 1, kMaxWavelengths);
    require_finite(wavelengths, "a wavelength is not finite");
    require_content(
        !wavelengths.empty() && std::adjacent_find(wavelengths.begin(), wavelengths.end(),
                                                   std::greater_equal<>()) == wavelengths.end(),
        "wavelengths must increase");

    solver::SolvedPaint paint;
    paint.recipe = parse_recipe(recipe, name + "/recipe", "");
    {
        const Hdf5Handle group(H5Gopen2(file, "settings", H5P_DEFAULT), "open group settings");
        paint.settings = {
            read_int_attribute(group, "exit_nodes"), read_int_attribute(group, "inner_nodes"),
            read_int_attribute(group, "most_orders"), read_double_attribute(group, "tolerance")};
    }
    {
        const Hdf5Handle group(H5Gopen2(file, "report", H5P_DEFAULT), "open group report");
        paint.report = {read_int_attribute(group, "exit_nodes"),
                        read_int_attribute(group, "inner_nodes"),
                        read_int_attribute(group, "orders"),
                        read_double_attribute(group, "unresolved_scattering"),
                        read_double_attribute(group, "azimuthal_tail")};
    }
    paint.medium = solver::make_medium(paint.recipe, wavelengths);
    paint.multiple_scattering = read_tensor(file, kMultipleScattering, wavelengths.size());
    if (paint.medium.roughness > 0) {
        paint.rough_single = read_tensor(file, kRoughSingle, wavelengths.size());
        require_content(paint.rough_single.exit_angle == paint.multiple_scattering.exit_angle,
                        "the exit angles of remainder and rough_single differ");
    } else {
        require_content(H5Lexists(file, kRoughSingle.name, H5P_DEFAULT) == 0,
                        "there is a group rough_single, but the interface is smooth");
    }
    return paint;
}

}  // namespace

bool looks_like_solved_paint(std::string_view bytes) {
    return is_sealed_as(kSolvedPaintFormat, bytes);
}

std::string solved_paint_bytes(const solver::SolvedPaint& paint) {
    return sealed_bytes(kSolvedPaintFormat, [&](hid_t file) {
        write_attribute(file, "recipe_sha256", recipe_hash(paint.recipe));
        write_text(file, "recipe", kept_recipe(paint.recipe), "the paint's recipe, TOML");
        write_array(file, "wavelengths_nm", {paint.wavelengths_nm().size()},
                    paint.wavelengths_nm().data(), "nm", "vacuum wavelengths");
        write_settings(file, paint.settings);
        write_solver_report(file, paint.report);
        write_tensor(file, kMultipleScattering, paint.multiple_scattering);
        if (paint.medium.roughness > 0) write_tensor(file, kRoughSingle, paint.rough_single);
    });
}

void write_solved_paint(const std::filesystem::path& path, const solver::SolvedPaint& paint) {
    write_file_atomically(path, solved_paint_bytes(paint));
}

solver::SolvedPaint parse_solved_paint(std::string_view bytes, const std::string& name) {
    solver::SolvedPaint paint;
    read_sealed(kSolvedPaintFormat, bytes, name,
                [&](hid_t file) { paint = read_contents(file, name); });
    return paint;
}

solver::SolvedPaint read_solved_paint(const std::filesystem::path& path) {
    return parse_solved_paint(read_file(path, kMaxSolvedPaintBytes), path.string());
}

}  // namespace nacre::io
