#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>

#include <utility>

#include "arrays.h"
#include "nacre/io/image.h"

namespace nacre::python {

/// The channels of a picture by name, (height, width) float32 each, and its metadata.
inline nb::tuple to_arrays(io::Image image) {
    const Shape shape = {static_cast<std::size_t>(image.height),
                         static_cast<std::size_t>(image.width)};
    nb::dict channels;
    for (io::Channel& channel : image.channels) {
        channels[channel.name.c_str()] = to_numpy(std::move(channel.pixels), shape);
    }
    return nb::make_tuple(channels, nb::cast(image.metadata));
}

}  // namespace nacre::python
