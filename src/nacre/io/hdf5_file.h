#pragma once

#include <hdf5.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/progress.h"

// A thin layer over the C library: handles that close themselves, and errors that are thrown.

namespace nacre::io {

/// Closes a handle of any kind when it goes.
class Hdf5Handle {
 public:
    /// @throws Error "cannot `action`" if the handle is not valid
    Hdf5Handle(hid_t id, const std::string& action);
    ~Hdf5Handle();
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_) { other.id_ = H5I_INVALID_HID; }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    operator hid_t() const { return id_; }  // NOLINT: what the C functions take

 private:
    hid_t id_;
};

/// While it lives, HDF5 prints nothing to stderr; failures still come back as return values.
class Hdf5Silence {
 public:
    Hdf5Silence();
    ~Hdf5Silence();
    Hdf5Silence(const Hdf5Silence&) = delete;
    Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

using Hdf5Shape = std::vector<hsize_t>;

void write_attribute(hid_t object, const char* name, const std::string& text);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, int value);
std::string read_text_attribute(hid_t object, const char* name);
double read_double_attribute(hid_t object, const char* name);
int read_int_attribute(hid_t object, const char* name);

/// Makes a group with `meaning` as its attribute.
Hdf5Handle write_group(hid_t parent, const char* name, const char* meaning);
/// Writes an array with `unit` and `meaning` as its attributes; compressed where that pays, and then
/// in pieces along its first dimension where it is long.
/// @throws Stopped if `work`, which may be null, asks to stop
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const double* values,
                 const char* unit, const char* meaning);
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const float* values,
                 const char* unit, const char* meaning, SharedProgress* work = nullptr);
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const int* values,
                 const char* unit, const char* meaning);
void write_array(hid_t parent, const char* name, const Hdf5Shape& shape, const std::int64_t* values,
                 const char* unit, const char* meaning);
void write_text(hid_t parent, const char* name, const std::string& text, const char* meaning);

/// Shape of an array of `rank` dimensions.
/// @throws Error if it is not there, has another rank or more than `max_values` values
Hdf5Shape array_shape(hid_t parent, const char* name, std::size_t rank, std::size_t max_values);
std::vector<double> read_doubles(hid_t parent, const char* name, std::size_t rank,
                                 std::size_t max_values);
std::vector<float> read_floats(hid_t parent, const char* name, std::size_t rank,
                               std::size_t max_values);
std::vector<int> read_ints(hid_t parent, const char* name, std::size_t rank,
                           std::size_t max_values);
std::vector<std::int64_t> read_int64s(hid_t parent, const char* name, std::size_t rank,
                                      std::size_t max_values);
std::string read_text(hid_t parent, const char* name, std::size_t max_bytes);

/// What a file says must make sense. @throws Error `what`
void require_content(bool ok, const char* what);
template <class T>
void require_finite(const std::vector<T>& values, const char* what) {
    for (const T value : values) require_content(std::isfinite(value), what);
}

// HDF5 files behind a head of 512 bytes of text that says what this is, and version, size and
// SHA-256 of the rest. The checksum is verified before HDF5 sees a byte: its library is not made
// for damaged files. Files are made and read in memory.

struct SealedFormat {
    std::string_view name;  ///< the first line of the head, and the attribute `format`
    int version;
    std::string_view noun;  ///< for messages: "is not a `noun` of Nacre"
};

/// Whether the bytes start like a file of that format.
bool is_sealed_as(const SealedFormat& format, std::string_view bytes);

/// The bytes of a file: `write` fills the root group, which has attributes format, format_version
/// and nacre_version already.
std::string sealed_bytes(const SealedFormat& format, const std::function<void(hid_t)>& write);

/// Calls `read` with the root group of a file; `name` is for messages.
/// @throws InputError naming the file if it is cut short, altered, of another version or format, or
/// if HDF5 or `read` throw an Error
void read_sealed(const SealedFormat& format, std::string_view bytes, const std::string& name,
                 const std::function<void(hid_t)>& read);

}  // namespace nacre::io
