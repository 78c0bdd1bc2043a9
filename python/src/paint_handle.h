#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "nacre/nacre.h"

namespace nacre::python {

/// A paint, and the BRDFs that were last asked of it, so that a call for one value costs no more
/// than that. Those are read and written by threads that hold the GIL.
struct PaintHandle {
    struct Known {
        std::vector<double> wavelengths_nm;
        std::optional<Model> model;
        Part part;
        bool as_rendered;
        std::optional<std::tuple<double, double, double>> patch;
        std::shared_ptr<const PaintBrdf> brdf;
    };

    Paint paint;
    mutable std::vector<Known> brdfs = {};
};

}  // namespace nacre::python
