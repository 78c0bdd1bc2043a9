#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/nacre.h"

namespace nacre::python {

/// The surface that a renderer sees.
struct Look {
    std::shared_ptr<const bsdf::Bsdf> surface;
    /// For the wavelengths that were asked for last, by threads that hold the GIL.
    mutable std::vector<std::pair<std::vector<double>, std::shared_ptr<const bsdf::BoundBsdf>>>
        bound = {};
};

/// A paint, and the BRDFs and looks that were last asked of it, so that a call for one value costs
/// no more than that. Those are read and written by threads that hold the GIL.
struct PaintHandle {
    struct Known {
        std::vector<double> wavelengths_nm;
        std::optional<Model> model;
        Part part;
        bool as_rendered;
        bool patches;
        std::shared_ptr<const PaintBrdf> brdf;
    };

    struct KnownLook {
        std::optional<Model> model;
        SolveSettings solve;
        std::shared_ptr<const Look> look;
    };

    Paint paint;
    mutable std::vector<Known> brdfs = {};
    mutable std::vector<KnownLook> looks = {};
};

}  // namespace nacre::python
