#pragma once

#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"

namespace nacre::bsdf {

/// A Lambertian surface whose reflectance is read from a picture: linear Rec. 709 between the
/// middles of pixels, bilinear, repeated beyond the edges; a colour becomes a spectrum by
/// spectra::linear_rec709_basis(), which keeps it under D65.
class DiffusePicture final : public Bsdf {
 public:
    struct Pixels {
        int width = 0, height = 0;
        std::vector<float> rgb;  ///< 3 x width x height, row-major from the top, each in [0, 1]
    };
    /// @throws DomainError if the sizes do not fit, or a value leaves [0, 1]
    explicit DiffusePicture(Pixels pixels);

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    SurfaceCoordinates surface_coordinates() const override {
        return SurfaceCoordinates::place_in_unit_square;
    }

 private:
    std::shared_ptr<const Pixels> pixels_;
};

}  // namespace nacre::bsdf
