#pragma once

#include <memory>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/layers/brdf_table_grid.h"
#include "nacre/layers/rough_interface.h"
#include "nacre/layers/solved_paint.h"
#include "nacre/layers/wavelength_groups.h"
#include "nacre/spectra/observer.h"

// SolvedPaint::brdf on the nodes of a grid, in RGB, fast: what depends on wavelength alone, or on
// one direction, is worked out once, and spectra become colours before they are summed over
// azimuthal orders.

namespace nacre::layers {

class BrdfTableRows {
 public:
    /// Keeps references to both.
    BrdfTableRows(const SolvedPaint& paint, const BrdfGrid& grid);

    /// One incident node, and room to work in.
    struct Workspace {
        int i;
        double theta_i;
        std::vector<RemainderSlice> slices;  // one per tensor
        std::vector<double> azimuth, term;
        std::vector<spectra::Vec3> by_order, rgb;
    };
    Workspace make_workspace(int i) const;

    /// g of the incident node and one outgoing node: `out` holds [azimuth][channel].
    void evaluate(Workspace& work, int o, float* out) const;

 private:
    // Wavelengths at which the binder has one index, and the paint differs.
    struct Group {
        double ior;
        PaintMedium medium;
        /// Weights of the wavelengths for red, green, blue, and zero for lanes beyond the last:
        /// [block].
        std::vector<std::array<DoubleLanes, 3>> weights;
        spectra::Vec3 white{};  ///< their sum
        /// Colours of the elements of the tensors' spectral bases: [tensor][k].
        std::vector<std::vector<spectra::Vec3>> basis;
        /// Extinction: [layer][node][block].
        std::vector<std::vector<DoubleLanes>> extinction;
        std::shared_ptr<const RoughInterface> interface;
        std::vector<double> masked;  ///< by node, under a rough interface
    };

    Group make_group(const WavelengthGroup& wavelengths,
                     const std::vector<spectra::Vec3>& weights) const;
    double scale(const Group& group, double theta_i, double theta_o) const;
    void add_tensors(Workspace& work, double theta_o) const;
    void add_single(const Group& group, double scale, Workspace& work, int o) const;
    void add_interface(const Group& group, double scale, Workspace& work, int o) const;

    const SolvedPaint& paint_;
    const BrdfGrid& grid_;
    std::vector<const Remainder*> tensors_;
    std::vector<Group> groups_;
};

}  // namespace nacre::layers
