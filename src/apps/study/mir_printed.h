#pragma once

#include <array>

// Every number that Mir, Yildirim and Kurt print in their comparison, as they print it [mir-2022].
// The study sets it beside its own; a test holds the recipes of the study to it.

namespace nacre::study::printed {

inline constexpr int kPictureSize = 512, kSamples = 1024;

/// Table 1: seconds of rendering, and sizes of data in megabytes.
struct DataTimes {
    const char* paint;  ///< file name of the recipe, without its ending
    std::array<double, 3> rgb;
    double monte_carlo_s, raw_s, compressed_s;
    double compressed_mb;

    constexpr double monte_carlo_over_raw() const { return monte_carlo_s / raw_s; }
    constexpr double compressed_over_raw() const { return compressed_s / raw_s; }
};
inline constexpr DataTimes kTable1[] = {{"metallic-gray", {0.6, 0.6, 0.6}, 43 * 60, 6.8, 4.5, 4.5},
                                        {"cadmium-red", {0.89, 0, 0.13}, 72 * 60, 4.65, 4.21, 5}};
inline constexpr double kRawMb = 96;
inline constexpr int kPolarAngles = 256, kAzimuths = 128;  ///< n, m
inline constexpr double kMinLoss_db = 0.02, kMaxLoss_db = 0.03;
inline constexpr double kMinPrecomputation_s = 1.9 * 60, kMaxPrecomputation_s = 2 * 60;

/// Table 2: hours for the model of Guo et al., by the number of facets.
inline constexpr std::array<double, 3> kFacetCounts = {1e7, 1e8, 1e9};
inline constexpr double kAlpha = 0.07, kCone_deg = 3;
struct FacetSet {
    double path_nm;   ///< P_inc = 2 eta_2 d
    double film_ior;  ///< eta_2
    double base_ior, base_extinction;
    std::array<double, 3> hours;

    constexpr double max_min_ratio() const { return hours[2] / hours[0]; }
};
inline constexpr FacetSet kTable2[] = {{570, 1.8, 1.08, 0.51, {2.22, 2.38, 3.49}},
                                       {665, 1.97, 1.12, 0, {2.23, 2.42, 3.52}}};

/// Table 4: seconds by row of Figure 4. Ergun's column is flakes with so much titania; those of
/// Belcour and Barla and of Guo without sparkle are the two sets of Table 2.
struct ModelTimes {
    double titania_nm;
    double ergun_s, belcour_s, guo_smooth_s;

    constexpr double belcour_over_ergun() const { return belcour_s / ergun_s; }
    constexpr double guo_over_ergun() const { return guo_smooth_s / ergun_s; }
};
inline constexpr ModelTimes kTable4[] = {{80, 7.29, 78, 335}, {110, 7.36, 80, 347}};

}  // namespace nacre::study::printed
