#include "nacre/io/solved_paint_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/core/sha256.h"
#include "nacre/io/hdf5_handle.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/table_reader.h"
#include "nacre/io/version.h"

namespace nacre::io {

namespace {

constexpr std::string_view kFormat = "nacre solved paint";
constexpr std::size_t kUserBlockBytes = 512;  // the smallest that HDF5 looks behind
constexpr std::size_t kMostWavelengths = 10'000;
constexpr std::size_t kMostCoefficients = std::size_t{1} << 26;
constexpr std::size_t kMostAzimuthalOrders = 65'536;
constexpr std::size_t kMostExitNodes = 4'096;

// ------------------------------------------------------------------------------- user block

/// Lines that a person reads with `head -c 512`, filled up with zeros.
std::string user_block(std::string_view body) {
    std::string block =
        fmt::format("{}\nversion {}\nbytes {}\nsha256 {}\nThe rest is HDF5: h5dump, h5py.\n",
                    kFormat, kSolvedPaintFormatVersion, body.size(), sha256_hex(body));
    block.resize(kUserBlockBytes, '\0');
    return block;
}

/// What follows "key " on a line of the block.
std::string_view field(std::string_view block, std::string_view key) {
    const std::string start = fmt::format("\n{} ", key);
    const std::size_t at = block.find(start);
    if (at == std::string_view::npos) return {};
    const std::string_view rest = block.substr(at + start.size());
    return rest.substr(0, rest.find('\n'));
}

/// The HDF5 part, once size and checksum have been found right.
std::string_view checked_body(std::string_view bytes, const std::string& name) {
    if (!looks_like_solved_paint(bytes)) {
        throw InputError(fmt::format("{}: is not a solved paint of Nacre", name));
    }
    if (bytes.size() < kUserBlockBytes) {
        throw InputError(fmt::format("{}: is cut short", name));
    }
    const std::string_view block = bytes.substr(0, kUserBlockBytes);
    const std::string_view body = bytes.substr(kUserBlockBytes);
    const std::string_view version = field(block, "version");
    if (version != std::to_string(kSolvedPaintFormatVersion)) {
        throw InputError(fmt::format("{}: has format version {}; this program reads {}", name,
                                     version.substr(0, 20), kSolvedPaintFormatVersion));
    }
    if (field(block, "bytes") != std::to_string(body.size())) {
        throw InputError(
            fmt::format("{}: is cut short or altered: {} bytes follow its head, not {}", name,
                        body.size(), field(block, "bytes").substr(0, 20)));
    }
    if (field(block, "sha256") != sha256_hex(body)) {
        throw InputError(fmt::format("{}: is damaged: its checksum does not fit", name));
    }
    return body;
}

// ---------------------------------------------------------------------------------- writing

Hdf5Handle make_group(hid_t parent, const char* name, const char* meaning) {
    Hdf5Handle group(H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     fmt::format("make group {}", name));
    write_attribute(group, "meaning", std::string(meaning));
    return group;
}

void write_settings(hid_t file, const layers::SolverSettings& settings) {
    const Hdf5Handle group =
        make_group(file, "settings", "how finely to solve; 0: chosen from the recipe");
    write_attribute(group, "exit_nodes", settings.exit_nodes);
    write_attribute(group, "inner_nodes", settings.inner_nodes);
    write_attribute(group, "most_orders", settings.most_orders);
    write_attribute(group, "tolerance", settings.tolerance);
}

void write_solver_report(hid_t file, const layers::SolverReport& report) {
    const Hdf5Handle group = make_group(file, "report", "what the solver found out about itself");
    write_attribute(group, "exit_nodes", report.exit_nodes);
    write_attribute(group, "inner_nodes", report.inner_nodes);
    write_attribute(group, "orders", report.orders);
    write_attribute(group, "unresolved_scattering", report.unresolved_scattering);
    write_attribute(group, "azimuthal_tail", report.azimuthal_tail);
}

/// Where the tensors stand, and what their meaning says before the formula.
struct TensorGroup {
    const char* name;
    const char* meaning;
};
constexpr TensorGroup kRemainder = {
    "remainder", "multiple scattering, without its Fresnel factors if the interface is smooth"};
constexpr TensorGroup kRoughSingle = {"rough_single", "single scattering under a rough interface"};

void write_tensor(hid_t file, const TensorGroup& where, const layers::Remainder& r) {
    const std::string meaning = fmt::format(
        "{}: f(theta_i, theta_o, phi; wavelength) = sum_l (2 - delta_l0) cos(l (phi - pi)) sum_k "
        "basis[k][wavelength] coefficient[k][pair(l, i, j)]; pairs by order l, then rows i >= j "
        "from node first[l]; phi = phi_o - phi_i",
        where.meaning);
    const Hdf5Handle group = make_group(file, where.name, meaning.c_str());
    const auto size = [](const auto& v) { return static_cast<hsize_t>(v.size()); };
    const hsize_t rank = static_cast<hsize_t>(r.rank());
    const hsize_t pairs = rank > 0 ? size(r.coefficient) / rank : 0;
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
std::string kept_recipe(const layers::Recipe& recipe) {
    std::string text = write_recipe(recipe);
    try {
        parse_recipe(text, "recipe", "");
    } catch (const InputError& error) {
        throw Error(fmt::format("a solved file cannot keep this paint: {}", error.what()));
    }
    return text;
}

std::string hdf5_image(hid_t file) {
    if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) throw Error("cannot finish the HDF5 file");
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    if (size <= 0) throw Error("cannot get the HDF5 file's bytes");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file, bytes.data(), bytes.size()) != size) {
        throw Error("cannot get the HDF5 file's bytes");
    }
    return bytes;
}

/// HDF5 wants a name even for a file in memory, and refuses that of a file that exists: this
/// cannot.
constexpr const char* kNoFile = "/dev/null/solved paint";

/// Access to a file that lives in memory only, seeded with `image` unless that is empty.
Hdf5Handle memory_access(std::string_view image) {
    constexpr std::size_t kGrowth = 1 << 16;
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "set up HDF5");
    // The library copies the image before it looks at it; its argument lacks a const.
    if (H5Pset_fapl_core(access, kGrowth, false) < 0 ||
        (!image.empty() &&
         H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()) < 0)) {
        throw Error("cannot set up HDF5");
    }
    return access;
}

// ---------------------------------------------------------------------------------- reading

void require(bool ok, const char* what) {
    if (!ok) throw Error(what);
}

template <class T>
void require_finite(const std::vector<T>& values, const char* what) {
    require(std::all_of(values.begin(), values.end(), [](T v) { return std::isfinite(v); }), what);
}

layers::Remainder read_tensor(hid_t file, const TensorGroup& where, std::size_t wavelengths) {
    const Hdf5Handle group(H5Gopen2(file, where.name, H5P_DEFAULT),
                           fmt::format("open group {}", where.name));
    layers::Remainder r;
    r.wavelength_count = static_cast<int>(wavelengths);
    r.exit_angle = read_doubles(group, "exit_angle", 1, kMostExitNodes);
    r.first = read_ints(group, "first", 1, kMostAzimuthalOrders);
    r.basis = read_floats(group, "basis", 2, wavelengths * wavelengths);
    r.coefficient = read_floats(group, "coefficient", 2, kMostCoefficients);
    require_finite(r.exit_angle, "an exit angle is not finite");
    require_finite(r.basis, "a spectral basis is not finite");
    require_finite(r.coefficient, "a coefficient is not finite");

    const int nodes = static_cast<int>(r.exit_angle.size());
    require(nodes > 0, "there are no exit angles");
    for (int i = 0; i < nodes; ++i) {
        require(r.exit_angle[i] >= (i ? r.exit_angle[i - 1] : 0.0) &&
                    r.exit_angle[i] <= std::numbers::pi / 2,
                "exit angles must increase within [0, pi/2]");
    }
    for (int first : r.first) require(first >= 0 && first <= nodes, "a first node is out of range");
    const Hdf5Shape basis = array_shape(group, "basis", 2, wavelengths * wavelengths);
    const Hdf5Shape coefficient = array_shape(group, "coefficient", 2, kMostCoefficients);
    require(basis[1] == wavelengths && coefficient[0] == basis[0] &&
                coefficient[1] == (basis[0] ? r.pair_count() : 0),
            "the sizes of the arrays do not fit together");
    return r;
}

layers::SolvedPaint read_contents(hid_t file, const std::string& name) {
    require(read_text_attribute(file, "format") == kFormat, "attribute format is another");
    const std::string recipe = read_text(file, "recipe", kMostTextBytes);
    const std::vector<double> wavelengths =
        read_doubles(file, "wavelengths_nm", 1, kMostWavelengths);
    require_finite(wavelengths, "a wavelength is not finite");
    require(!wavelengths.empty() && std::adjacent_find(wavelengths.begin(), wavelengths.end(),
                                                       std::greater_equal<>()) == wavelengths.end(),
            "wavelengths must increase");

    layers::SolvedPaint paint;
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
    paint.medium = layers::make_medium(paint.recipe, wavelengths);
    paint.remainder = read_tensor(file, kRemainder, wavelengths.size());
    if (paint.medium.roughness > 0) {
        paint.rough_single = read_tensor(file, kRoughSingle, wavelengths.size());
        require(paint.rough_single.exit_angle == paint.remainder.exit_angle,
                "the exit angles of remainder and rough_single differ");
    } else {
        require(H5Lexists(file, kRoughSingle.name, H5P_DEFAULT) == 0,
                "there is a group rough_single, but the interface is smooth");
    }
    return paint;
}

}  // namespace

bool looks_like_solved_paint(std::string_view bytes) {
    return bytes.starts_with(std::string(kFormat) + "\n");
}

std::string solved_paint_bytes(const layers::SolvedPaint& paint) {
    const Hdf5Silence silence;
    const Hdf5Handle access = memory_access({});
    const Hdf5Handle file(H5Fcreate(kNoFile, H5F_ACC_TRUNC, H5P_DEFAULT, access),
                          "make an HDF5 file");
    write_attribute(file, "format", std::string(kFormat));
    write_attribute(file, "format_version", kSolvedPaintFormatVersion);
    write_attribute(file, "nacre_version", std::string(version()));
    write_attribute(file, "recipe_sha256", recipe_hash(paint.recipe));
    write_text(file, "recipe", kept_recipe(paint.recipe), "the paint's recipe, TOML");
    write_array(file, "wavelengths_nm", {paint.wavelengths_nm().size()},
                paint.wavelengths_nm().data(), "nm", "vacuum wavelengths");
    write_settings(file, paint.settings);
    write_solver_report(file, paint.report);
    write_tensor(file, kRemainder, paint.remainder);
    if (paint.medium.roughness > 0) write_tensor(file, kRoughSingle, paint.rough_single);
    const std::string body = hdf5_image(file);
    return user_block(body) + body;
}

void write_solved_paint(const std::filesystem::path& path, const layers::SolvedPaint& paint) {
    write_file_atomically(path, solved_paint_bytes(paint));
}

layers::SolvedPaint parse_solved_paint(std::string_view bytes, const std::string& name) {
    const std::string_view body = checked_body(bytes, name);
    const Hdf5Silence silence;
    try {
        const Hdf5Handle access = memory_access(body);
        const Hdf5Handle file(H5Fopen(kNoFile, H5F_ACC_RDONLY, access), "open it as an HDF5 file");
        return read_contents(file, name);
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(
            fmt::format("{}: is not a solved paint that can be used: {}", name, error.what()));
    }
}

layers::SolvedPaint read_solved_paint(const std::filesystem::path& path) {
    return parse_solved_paint(read_file(path, kMostSolvedPaintBytes), path.string());
}

}  // namespace nacre::io
