#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "bind.h"
#include "image_arrays.h"
#include "nacre/io/image.h"
#include "nacre/nacre.h"

namespace nacre::python {

namespace {

using namespace nb::literals;

using Floats = nb::ndarray<const float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

io::Image image_of(const std::map<std::string, Floats>& channels,
                   const std::map<std::string, std::string>& metadata) {
    if (channels.empty()) throw DomainError("channels: there is none");
    const Floats& first = channels.begin()->second;
    io::Image image;
    image.height = static_cast<int>(first.shape(0));
    image.width = static_cast<int>(first.shape(1));
    image.metadata = metadata;
    for (const auto& [name, pixels] : channels) {
        if (pixels.shape(0) != first.shape(0) || pixels.shape(1) != first.shape(1)) {
            throw DomainError("channels: " + name + " has another shape than the others");
        }
        image.channels.push_back({name, {pixels.data(), pixels.data() + pixels.size()}});
    }
    return image;
}

nb::tuple read_image(const std::filesystem::path& path) {
    io::Image image = [&] {
        const nb::gil_scoped_release release;
        return io::read_image(path);
    }();
    return to_arrays(std::move(image));
}

void write_image(const std::filesystem::path& path, const std::map<std::string, Floats>& channels,
                 const std::map<std::string, std::string>& metadata, double exposure_stops) {
    const io::Image image = image_of(channels, metadata);
    const nb::gil_scoped_release release;
    if (path.extension() == ".exr") return io::write_exr(path, image);
    if (path.extension() == ".png") return io::write_png(path, image, {exposure_stops});
    throw SettingError("path", "must end in .exr or .png", path.string());
}

nb::bytes encode_png(const std::map<std::string, Floats>& channels, double exposure_stops) {
    const std::string bytes = io::encode_png(image_of(channels, {}), "picture", {exposure_stops});
    return nb::bytes(bytes.data(), bytes.size());
}

}  // namespace

void bind_images(nb::module_& module) {
    module.attr("EXPOSURE_RANGE") = nb::make_tuple(io::kExposureRange.lo, io::kExposureRange.hi);
    module.def("read_image", &read_image, "path"_a);
    module.def("write_image", &write_image, "path"_a, "channels"_a, "metadata"_a,
               "exposure_stops"_a);
    module.def("encode_png", &encode_png, "channels"_a, "exposure_stops"_a);
}

}  // namespace nacre::python
