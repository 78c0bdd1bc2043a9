#include "nacre/io/sealed_hdf5.h"

#include "nacre/core/error.h"
#include "nacre/core/sha256.h"
#include "nacre/io/version.h"

namespace nacre::io {

namespace {

constexpr std::size_t kUserBlockBytes = 512;  // the smallest that HDF5 looks behind

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
    if (field(block, "sha256") != sha256_hex(body)) {
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

/// HDF5 wants a name even for a file in memory, and refuses that of a file that exists: this
/// cannot.
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
    const Hdf5Handle file(H5Fcreate(kNoFile, H5F_ACC_TRUNC, H5P_DEFAULT, access),
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
