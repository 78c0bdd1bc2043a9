#include "nacre/io/hdf5_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/sha256.h"
#include "nacre/core/version.h"

namespace nacre::io {

namespace {

constexpr std::size_t kMaxAttributeBytes = 4096;
/// Below this many bytes the header of a compressed chunk costs more than it saves.
constexpr std::size_t kWorthCompressing = 2048;
constexpr unsigned kDeflateLevel = 6;
/// Larger arrays are cut into chunks of at most this size where their first dimension allows it:
/// deflating this much takes a fraction of a second.
constexpr std::size_t kMaxChunkBytes = 4 << 20;

void require(bool ok, const std::string& action) {
    if (!ok) throw Error("cannot " + action);
}

Hdf5Handle text_type(std::size_t size) {
    Hdf5Handle type(H5Tcopy(H5T_C_S1), "make a text type");
    // A length of zero does not exist; the text then is one 0 byte.
    require(H5Tset_size(type, std::max<std::size_t>(size, 1)) >= 0, "set a text's size");
    require(H5Tset_cset(type, H5T_CSET_UTF8) >= 0, "set a text's encoding");
    require(H5Tset_strpad(type, H5T_STR_NULLPAD) >= 0, "set a text's padding");
    return type;
}

/// Properties of a new object. HDF5 would note when it was made: files of the same contents would
/// differ from one second to the next.
Hdf5Handle creation_properties(hid_t kind) {
    Hdf5Handle properties(H5Pcreate(kind), "set up HDF5");
    require(H5Pset_obj_track_times(properties, false) >= 0, "set up HDF5");
    return properties;
}

void write_scalar_attribute(hid_t object, const char* name, hid_t type, const void* value) {
    const std::string action = fmt::format("write attribute {}", name);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), action);
    const Hdf5Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                               action);
    require(H5Awrite(attribute, type, value) >= 0, action);
}

template <class T>
T read_scalar_attribute(hid_t object, const char* name, hid_t type, H5T_class_t wanted) {
    const std::string action = fmt::format("read attribute {}", name);
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), action);
    const Hdf5Handle stored(H5Aget_type(attribute), action);
    const Hdf5Handle space(H5Aget_space(attribute), action);
    require(H5Tget_class(stored) == wanted && H5Sget_simple_extent_npoints(space) == 1, action);
    T value{};
    require(H5Aread(attribute, type, &value) >= 0, action);
    return value;
}

/// Writes rows [first, first + count) of an array.
void write_rows(hid_t set, const Hdf5Shape& shape, hid_t type, const char* values, hsize_t first,
                hsize_t count, const std::string& action) {
    Hdf5Shape start(shape.size(), 0), size = shape;
    start[0] = first;
    size[0] = count;
    const Hdf5Handle in_memory(
        H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), action);
    const Hdf5Handle in_file(H5Dget_space(set), action);
    require(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, size.data(),
                                nullptr) >= 0 &&
                H5Dwrite(set, type, in_memory, in_file, H5P_DEFAULT, values) >= 0,
            action);
}

void write_typed_array(hid_t parent, const char* name, const Hdf5Shape& shape, hid_t type,
                       const void* values, const char* unit, const char* meaning,
                       SharedProgress* work = nullptr) {
    const std::string action = fmt::format("write array {}", name);
    std::size_t bytes = H5Tget_size(type);
    for (hsize_t n : shape) bytes *= n;
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                           action);
    const Hdf5Handle properties = creation_properties(H5P_DATASET_CREATE);
    Hdf5Shape chunk = shape;
    if (bytes >= kWorthCompressing) {
        const std::size_t row_bytes = bytes / shape[0];
        chunk[0] = std::clamp<hsize_t>(kMaxChunkBytes / row_bytes, 1, shape[0]);
        require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) >= 0 &&
                    H5Pset_shuffle(properties) >= 0 &&
                    H5Pset_deflate(properties, kDeflateLevel) >= 0,
                action);
    }
    const Hdf5Handle set(
        H5Dcreate2(parent, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), action);
    for (hsize_t first = 0; bytes > 0 && first < shape[0]; first += chunk[0]) {
        if (work) work->throw_if_stopped("compressing the file");
        write_rows(set, shape, type, static_cast<const char*>(values) + first * (bytes / shape[0]),
                   first, std::min(chunk[0], shape[0] - first), action);
    }
    write_attribute(set, "unit", std::string(unit));
    write_attribute(set, "meaning", std::string(meaning));
}

template <class T>
std::vector<T> read_typed_array(hid_t parent, const char* name, std::size_t rank,
                                std::size_t max_values, hid_t type, H5T_class_t wanted) {
    const std::string action = fmt::format("read array {}", name);
    std::size_t count = 1;
    for (hsize_t n : array_shape(parent, name, rank, max_values)) count *= n;
    const Hdf5Handle set(H5Dopen2(parent, name, H5P_DEFAULT), action);
    const Hdf5Handle stored(H5Dget_type(set), action);
    require(H5Tget_class(stored) == wanted, action);
    std::vector<T> values(count);
    if (count > 0) {
        require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, action);
    }
    return values;
}

}  // namespace

Hdf5Handle::Hdf5Handle(hid_t id, const std::string& action) : id_(id) { require(id >= 0, action); }

Hdf5Handle::~Hdf5Handle() {
    if (id_ < 0) return;
    if (H5Iget_type(id_) == H5I_FILE) {
        H5Fclose(id_);
    } else {
        H5Idec_ref(id_);  // closes spaces, types, arrays, groups, attributes, property lists
    }
}

Hdf5Silence::Hdf5Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

void write_attribute(hid_t object, const char* name, const std::string& text) {
    // The library reads as many bytes as the type has, which for empty text is one.
    write_scalar_attribute(object, name, text_type(text.size()), text.c_str());
}
void write_attribute(hid_t object, const char* name, double value) {
    write_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}
void write_attribute(hid_t object, const char* name, int value) {
    write_scalar_attribute(object, name, H5T_NATIVE_INT, &value);
}

std::string read_text_attribute(hid_t object, const char* name) {
    const std::string action = fmt::format("read attribute {}", name);
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), action);
    const Hdf5Handle stored(H5Aget_type(attribute), action);
    const std::size_t size = H5Tget_size(stored);
    require(H5Tget_class(stored) == H5T_STRING && H5Tis_variable_str(stored) == 0 &&
                size <= kMaxAttributeBytes,
            action);
    std::string text(size, '\0');
    require(H5Aread(attribute, text_type(size), text.data()) >= 0, action);
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

double read_double_attribute(hid_t object, const char* name) {
    return read_scalar_attribute<double>(object, name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

int read_int_attribute(hid_t object, const char* name) {
    return read_scalar_attribute<int>(object, name, H5T_NATIVE_INT, H5T_INTEGER);
}

Hdf5Handle write_group(hid_t parent, const char* name, const char* meaning) {
    const Hdf5Handle properties = creation_properties(H5P_GROUP_CREATE);
    Hdf5Handle group(H5Gcreate2(parent, name, H5P_DEFAULT, properties, H5P_DEFAULT),
                     fmt::format("make group {}", name));
    write_attribute(group, "meaning", std::string(meaning));
    return group;
}

void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const double* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_DOUBLE, values, unit, meaning);
}
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const float* values,
                 const char* unit, const char* meaning, SharedProgress* work) {
    write_typed_array(parent, name, shape, H5T_NATIVE_FLOAT, values, unit, meaning, work);
}
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const int* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_INT, values, unit, meaning);
}
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const std::int64_t* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_INT64, values, unit, meaning);
}

void write_text(hid_t parent, const char* name, const std::string& text, const char* meaning) {
    const std::string action = fmt::format("write text {}", name);
    const Hdf5Handle type = text_type(text.size());
    const Hdf5Handle space(H5Screate(H5S_SCALAR), action);
    const Hdf5Handle properties = creation_properties(H5P_DATASET_CREATE);
    const Hdf5Handle set(
        H5Dcreate2(parent, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), action);
    require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, action);
    write_attribute(set, "meaning", std::string(meaning));
}

void require_content(bool ok, const char* what) {
    if (!ok) throw Error(what);
}

Hdf5Shape array_shape(hid_t parent, const char* name, std::size_t rank, std::size_t max_values) {
    const std::string action = fmt::format("read array {}", name);
    const Hdf5Handle set(H5Dopen2(parent, name, H5P_DEFAULT), action);
    const Hdf5Handle space(H5Dget_space(set), action);
    if (H5Sget_simple_extent_ndims(space) != static_cast<int>(rank)) {
        throw Error(fmt::format("array {} must have {} dimensions", name, rank));
    }
    Hdf5Shape shape(rank);
    require(H5Sget_simple_extent_dims(space, shape.data(), nullptr) >= 0, action);
    std::size_t remaining = max_values;
    for (hsize_t n : shape) {
        if (n > remaining)
            throw Error(fmt::format("array {} has more than {} values", name, max_values));
        if (n > 0) remaining /= n;
    }
    return shape;
}

std::vector<double> read_doubles(hid_t parent, const char* name, std::size_t rank,
                                 std::size_t max_values) {
    return read_typed_array<double>(parent, name, rank, max_values, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}
std::vector<float> read_floats(hid_t parent, const char* name, std::size_t rank,
                               std::size_t max_values) {
    return read_typed_array<float>(parent, name, rank, max_values, H5T_NATIVE_FLOAT, H5T_FLOAT);
}
std::vector<int> read_ints(hid_t parent, const char* name, std::size_t rank,
                           std::size_t max_values) {
    return read_typed_array<int>(parent, name, rank, max_values, H5T_NATIVE_INT, H5T_INTEGER);
}
std::vector<std::int64_t> read_int64s(hid_t parent, const char* name, std::size_t rank,
                                      std::size_t max_values) {
    return read_typed_array<std::int64_t>(parent, name, rank, max_values, H5T_NATIVE_INT64,
                                          H5T_INTEGER);
}

std::string read_text(hid_t parent, const char* name, std::size_t max_bytes) {
    const std::string action = fmt::format("read text {}", name);
    const Hdf5Handle set(H5Dopen2(parent, name, H5P_DEFAULT), action);
    const Hdf5Handle stored(H5Dget_type(set), action);
    const std::size_t size = H5Tget_size(stored);
    require(
        H5Tget_class(stored) == H5T_STRING && H5Tis_variable_str(stored) == 0 && size <= max_bytes,
        action);
    std::string text(size, '\0');
    require(H5Dread(set, text_type(size), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0, action);
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

namespace {

constexpr std::size_t kUserBlockBytes = 512;  // the smallest user block that HDF5 allows

/// Lines that a person reads with `head -c 512`, filled up with zeros.
std::string user_block(const SealedFormat& format, std::string_view body) {
    std::string block =
        fmt::format("{}\nversion {}\nbytes {}\nsha256 {}\nThe rest is HDF5: h5dump, h5py.\n",
                    format.name, format.version, body.size(), sha256_hex(body));
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

/// Looks at all characters, whatever they are: a fuzzer that is shown where a checksum begins to differ
/// learns to forge it, and tries the HDF5 library from then on in place of this program.
bool same(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    unsigned char difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
    return difference == 0;
}

/// The HDF5 part, once size and checksum have been found right.
std::string_view checked_body(const SealedFormat& format, std::string_view bytes,
                              const std::string& name) {
    if (!is_sealed_as(format, bytes)) {
        throw InputError(fmt::format("{}: is not a {} of Nacre", name, format.noun));
    }
    if (bytes.size() < kUserBlockBytes) {
        throw InputError(fmt::format("{}: is cut short", name));
    }
    const std::string_view block = bytes.substr(0, kUserBlockBytes);
    const std::string_view body = bytes.substr(kUserBlockBytes);
    const std::string_view version = field(block, "version");
    if (version != std::to_string(format.version)) {
        throw InputError(fmt::format("{}: has format version {}; this program reads {}", name,
                                     version.substr(0, 20), format.version));
    }
    if (field(block, "bytes") != std::to_string(body.size())) {
        throw InputError(
            fmt::format("{}: is cut short or altered: {} bytes follow its head, not {}", name,
                        body.size(), field(block, "bytes").substr(0, 20)));
    }
    if (!same(field(block, "sha256"), sha256_hex(body))) {
        throw InputError(fmt::format("{}: is damaged: its checksum does not fit", name));
    }
    return body;
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

/// HDF5 wants a name even for a file in memory, and refuses that of a file that exists: one of this
/// name cannot.
constexpr const char* kNoFile = "/dev/null/sealed";

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

}  // namespace

bool is_sealed_as(const SealedFormat& format, std::string_view bytes) {
    return bytes.starts_with(std::string(format.name) + "\n");
}

std::string sealed_bytes(const SealedFormat& format, const std::function<void(hid_t)>& write) {
    const Hdf5Silence silence;
    const Hdf5Handle access = memory_access({});
    const Hdf5Handle properties = creation_properties(H5P_FILE_CREATE);  // of the root group
    const Hdf5Handle file(H5Fcreate(kNoFile, H5F_ACC_TRUNC, properties, access),
                          "make an HDF5 file");
    write_attribute(file, "format", std::string(format.name));
    write_attribute(file, "format_version", format.version);
    write_attribute(file, "nacre_version", std::string(version()));
    write(file);
    const std::string body = hdf5_image(file);
    return user_block(format, body) + body;
}

void read_sealed(const SealedFormat& format, std::string_view bytes, const std::string& name,
                 const std::function<void(hid_t)>& read) {
    const std::string_view body = checked_body(format, bytes, name);
    const Hdf5Silence silence;
    try {
        const Hdf5Handle access = memory_access(body);
        const Hdf5Handle file(H5Fopen(kNoFile, H5F_ACC_RDONLY, access), "open it as an HDF5 file");
        if (read_text_attribute(file, "format") != format.name) {
            throw Error("attribute format is another");
        }
        read(file);
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(
            fmt::format("{}: is not a {} that can be used: {}", name, format.noun, error.what()));
    }
}

}  // namespace nacre::io
