#include "nacre/io/hdf5_handle.h"

#include "nacre/core/error.h"

namespace nacre::io {

namespace {

constexpr std::size_t kMostAttributeBytes = 4096;
/// Below this many bytes the header of a compressed chunk costs more than it saves.
constexpr std::size_t kWorthCompressing = 2048;
constexpr unsigned kDeflateLevel = 6;

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

void write_typed_array(hid_t parent, const char* name, const Hdf5Shape& shape, hid_t type,
                       const void* values, const char* unit, const char* meaning) {
    const std::string action = fmt::format("write array {}", name);
    std::size_t bytes = H5Tget_size(type);
    for (hsize_t n : shape) bytes *= n;
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                           action);
    const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), action);
    if (bytes >= kWorthCompressing) {
        require(H5Pset_chunk(properties, static_cast<int>(shape.size()), shape.data()) >= 0 &&
                    H5Pset_shuffle(properties) >= 0 &&
                    H5Pset_deflate(properties, kDeflateLevel) >= 0,
                action);
    }
    const Hdf5Handle set(
        H5Dcreate2(parent, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), action);
    if (bytes > 0) {
        require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, action);
    }
    write_attribute(set, "unit", std::string(unit));
    write_attribute(set, "meaning", std::string(meaning));
}

template <class T>
std::vector<T> read_typed_array(hid_t parent, const char* name, std::size_t rank, std::size_t most,
                                hid_t type, H5T_class_t wanted) {
    const std::string action = fmt::format("read array {}", name);
    std::size_t count = 1;
    for (hsize_t n : array_shape(parent, name, rank, most)) count *= n;
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
                size <= kMostAttributeBytes,
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

void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const double* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_DOUBLE, values, unit, meaning);
}
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const float* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_FLOAT, values, unit, meaning);
}
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const int* values,
                 const char* unit, const char* meaning) {
    write_typed_array(parent, name, shape, H5T_NATIVE_INT, values, unit, meaning);
}

void write_text(hid_t parent, const char* name, const std::string& text, const char* meaning) {
    const std::string action = fmt::format("write text {}", name);
    const Hdf5Handle type = text_type(text.size());
    const Hdf5Handle space(H5Screate(H5S_SCALAR), action);
    const Hdf5Handle set(
        H5Dcreate2(parent, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), action);
    require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, action);
    write_attribute(set, "meaning", std::string(meaning));
}

Hdf5Shape array_shape(hid_t parent, const char* name, std::size_t rank, std::size_t most) {
    const std::string action = fmt::format("read array {}", name);
    const Hdf5Handle set(H5Dopen2(parent, name, H5P_DEFAULT), action);
    const Hdf5Handle space(H5Dget_space(set), action);
    if (H5Sget_simple_extent_ndims(space) != static_cast<int>(rank)) {
        throw Error(fmt::format("array {} must have {} dimensions", name, rank));
    }
    Hdf5Shape shape(rank);
    require(H5Sget_simple_extent_dims(space, shape.data(), nullptr) >= 0, action);
    std::size_t room = most;
    for (hsize_t n : shape) {
        if (n > room) throw Error(fmt::format("array {} has more than {} values", name, most));
        if (n > 0) room /= n;
    }
    return shape;
}

std::vector<double> read_doubles(hid_t parent, const char* name, std::size_t rank,
                                 std::size_t most) {
    return read_typed_array<double>(parent, name, rank, most, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}
std::vector<float> read_floats(hid_t parent, const char* name, std::size_t rank, std::size_t most) {
    return read_typed_array<float>(parent, name, rank, most, H5T_NATIVE_FLOAT, H5T_FLOAT);
}
std::vector<int> read_ints(hid_t parent, const char* name, std::size_t rank, std::size_t most) {
    return read_typed_array<int>(parent, name, rank, most, H5T_NATIVE_INT, H5T_INTEGER);
}

std::string read_text(hid_t parent, const char* name, std::size_t most) {
    const std::string action = fmt::format("read text {}", name);
    const Hdf5Handle set(H5Dopen2(parent, name, H5P_DEFAULT), action);
    const Hdf5Handle stored(H5Dget_type(set), action);
    const std::size_t size = H5Tget_size(stored);
    require(H5Tget_class(stored) == H5T_STRING && H5Tis_variable_str(stored) == 0 && size <= most,
            action);
    std::string text(size, '\0');
    require(H5Dread(set, text_type(size), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0, action);
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

}  // namespace nacre::io
