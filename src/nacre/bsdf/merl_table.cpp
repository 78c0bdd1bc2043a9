#include "nacre/bsdf/merl_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::bsdf {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

HalfDifference MerlTable::middle(int h, int d, int a) const {
    const double x = (h + 0.5) / half;
    return {0.5 * kPi * x * x, 0.5 * kPi * (d + 0.5) / difference, kPi * (a + 0.5) / azimuths};
}

void validate(const MerlTable& table) {
    const auto side = [](const char* what, int cells) {
        if (cells < kLeastMerlCells || cells > kMostMerlCells) {
            throw DomainError(fmt::format("{} cells along {}: must be in [{}, {}]", cells, what,
                                          kLeastMerlCells, kMostMerlCells));
        }
    };
    side("theta_half", table.half);
    side("theta_difference", table.difference);
    side("phi_difference", table.azimuths);
    if (table.values.size() != 3 * table.cells()) {
        throw DomainError(fmt::format("{} values: must be three times {} x {} x {}",
                                      table.values.size(), table.half, table.difference,
                                      table.azimuths));
    }
    // Finite, and still so in single precision.
    const auto wrong = std::find_if(table.values.begin(), table.values.end(),
                                    [](double v) { return !(std::abs(v) <= 1e30); });
    if (wrong != table.values.end()) {
        throw DomainError(fmt::format("value {} is {}: must be a number in [-1e30, 1e30]",
                                      wrong - table.values.begin(), *wrong));
    }
}

HalfDifference half_difference(Vec3f wi, Vec3f wo) {
    const Vec3f h = normalize(wi + wo);
    const float sine = std::sqrt(h.x * h.x + h.y * h.y);
    const float cos_phi = sine > 0 ? h.x / sine : 1.0f, sin_phi = sine > 0 ? h.y / sine : 0.0f;
    // The frame about h whose first axis points away from the normal's side.
    const Vec3f first = {h.z * cos_phi, h.z * sin_phi, -sine}, second = {-sin_phi, cos_phi, 0};
    const float x = dot(wi, first), y = dot(wi, second), z = dot(wi, h);
    double phi = std::atan2(y, x);
    if (phi < 0) phi += kPi;  // reciprocity
    return {std::atan2(sine, h.z), std::atan2(std::sqrt(x * x + y * y), std::max(z, 0.0f)),
            std::min(phi, kPi)};
}

DirectionPair directions_of(const HalfDifference& angles) {
    const double sh = std::sin(angles.theta_half), ch = std::cos(angles.theta_half);
    const double sd = std::sin(angles.theta_difference), cd = std::cos(angles.theta_difference);
    const double x = sd * std::cos(angles.phi_difference), y = sd * std::sin(angles.phi_difference);
    return {{ch * x + sh * cd, y, -sh * x + ch * cd}, {-ch * x + sh * cd, -y, sh * x + ch * cd}};
}

}  // namespace nacre::bsdf
