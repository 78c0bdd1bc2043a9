#include "nacre/bsdf/paint_interface.h"

#include <fmt/format.h>

#include <numeric>

#include "nacre/core/error.h"

namespace nacre::bsdf {

bool has_rough_interface(const solver::SolvedPaint& paint, const char* done) {
    int rough = 0;
    for (int w = 0; w < paint.medium.wavelength_count(); ++w) rough += paint.is_rough(w);
    if (rough != 0 && rough != paint.medium.wavelength_count()) {
        throw Error(
            fmt::format("a rough clearcoat whose binder has the index 1 at some wavelengths only "
                        "cannot be {}",
                        done));
    }
    return rough != 0;
}

double mean_index(const solver::PaintMedium& medium) {
    return std::accumulate(medium.ior.begin(), medium.ior.end(), 0.0) /
           static_cast<double>(medium.ior.size());
}

}  // namespace nacre::bsdf
