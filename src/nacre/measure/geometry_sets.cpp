#include <fmt/format.h>

#include <array>

#include "nacre/measure/geometry.h"

// The sets that are built in. What stands where in public: docs/measure.md.

namespace nacre::measure {

namespace {

void add(std::vector<Geometry>& set, double theta_i_deg, std::initializer_list<double> aspecular) {
    for (double angle : aspecular) set.push_back(in_plane(theta_i_deg, angle));
}

/// One of the detectors off the plane of an instrument with two lamps, which is named after the
/// lamp that is on.
Geometry named(Geometry geometry, const char* name) {
    geometry.name = name;
    return geometry;
}

std::vector<Geometry> astm_e2194() {
    std::vector<Geometry> set;
    add(set, 45, {15, 45, 110});
    return set;
}

std::vector<Geometry> astm_e2539() {
    std::vector<Geometry> set;
    add(set, 45, {-15, 15, 25, 45, 75, 110});
    add(set, 15, {-15, 15});
    add(set, 65, {-15, 15});
    return set;
}

std::vector<Geometry> byk_mac() {
    std::vector<Geometry> set;
    add(set, 45, {-15, 15, 25, 45, 75, 110});
    return set;
}

/// In the plane by six detectors and two lamps; the pair 15as-5 is too near the gloss.
std::vector<Geometry> two_lamps_in_plane() {
    std::vector<Geometry> set;
    add(set, 45, {-15, 15, 25, 45, 75, 110});
    add(set, 15, {-45, -15, 15, 45, 80});
    return set;
}

/// Two detectors off the plane and their mirror images. The maker gives them as unit vectors, and
/// names that are rounded to a tenth of a degree [xrite-2026]: one 25 deg beside the mirror
/// direction of the lamp at 45 deg, one 45 deg from the normal and at right angles to the plane.
std::vector<Geometry> two_lamps_off_plane(bool both_sides) {
    const Geometry near = off_plane(45, 25, 90);
    std::vector<Geometry> set = {near, named(towards(45, 45, 90), "45as60az125.3"),
                                 named(towards(15, near.theta_o_deg, near.phi_deg), "15as38.3az43"),
                                 named(towards(15, 45, 90), "15as46.9az104.5")};
    if (both_sides) {
        for (std::size_t i = 0, count = set.size(); i < count; ++i) {
            Geometry other = set[i];
            const std::size_t turn = other.name.find("az") + 2;
            other.name = fmt::format("{}-{}", other.name.substr(0, turn), other.name.substr(turn));
            other.phi_deg = 360 - other.phi_deg;
            set.push_back(other);
        }
    }
    return set;
}

std::vector<Geometry> joined(std::vector<Geometry> a, const std::vector<Geometry>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Lamps at 0, 15 ... 75 deg; views every 15 deg of polar angle and 30 deg of azimuth on one side
/// of the plane: the other mirrors it.
std::vector<Geometry> full() {
    constexpr int kPolarStep_deg = 15, kAzimuthStep_deg = 30, kLast_deg = 75;
    std::vector<Geometry> set;
    for (int theta_i = 0; theta_i <= kLast_deg; theta_i += kPolarStep_deg) {
        for (int theta_o = 0; theta_o <= kLast_deg; theta_o += kPolarStep_deg) {
            // Along the normal, on either end, the azimuth has no meaning.
            const bool one_azimuth = theta_i == 0 || theta_o == 0;
            for (int phi = one_azimuth ? 180 : 0; phi <= 180; phi += kAzimuthStep_deg) {
                set.push_back(towards(theta_i, theta_o, phi));
            }
        }
    }
    return set;
}

}  // namespace

std::span<const GeometrySet> geometry_sets() {
    static const std::array<GeometrySet, 6> sets = {{
        {"astm-e2194", "45 deg lamp, 3 angles: metal flakes (ASTM E2194)", astm_e2194()},
        {"astm-e2539",
         "45, 15 and 65 deg lamps, 10 angles: interference pigments (after ASTM E2539)",
         astm_e2539()},
        {"byk-mac", "45 deg lamp, 6 angles: BYK-mac", byk_mac()},
        {"ma-t12", "45 and 15 deg lamps, 11 angles in the plane and 4 off it: after X-Rite MA-T12",
         joined(two_lamps_in_plane(), two_lamps_off_plane(false))},
        {"ma98", "45 and 15 deg lamps, 11 angles in the plane and 8 off it: X-Rite MA98",
         joined(two_lamps_in_plane(), two_lamps_off_plane(true))},
        {"full", "lamps and views over the hemisphere, 15 deg by 30 deg of azimuth", full()},
    }};
    return sets;
}

const GeometrySet* find_geometry_set(std::string_view name) {
    for (const GeometrySet& set : geometry_sets()) {
        if (set.name == name) return &set;
    }
    return nullptr;
}

}  // namespace nacre::measure
