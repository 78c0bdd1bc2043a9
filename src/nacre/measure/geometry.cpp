#include "nacre/measure/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/text.h"
#include "nacre/core/vec.h"

namespace nacre::measure {

namespace {

void require(double value, const Range& range, const char* what) {
    if (!range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", what, value, range.text()));
    }
}

/// Between unit vectors; exact for small angles too, where the arc cosine loses half its digits.
double angle_deg(const Vec3d& a, const Vec3d& b) {
    return 2 * std::atan2(length(a - b), length(a + b)) / kDegree;
}

Vec3d lamp(const Geometry& geometry) { return polar_direction(geometry.theta_i_deg, 0); }
Vec3d view(const Geometry& geometry) {
    return polar_direction(geometry.theta_o_deg, geometry.phi_deg);
}
Vec3d specular_direction(double theta_i_deg) { return polar_direction(theta_i_deg, 180); }

}  // namespace

Geometry in_plane(double theta_i_deg, double aspecular_deg) {
    require(theta_i_deg, kPolarAngleRange, "lamp in deg");
    const double view_deg = theta_i_deg - aspecular_deg;
    if (!(std::abs(view_deg) < 90)) {
        throw DomainError(
            fmt::format("aspecular angle = {} deg: with the lamp at {} deg it must be in ({}, {}), "
                        "or the view is below the horizon",
                        aspecular_deg, theta_i_deg, theta_i_deg - 90, theta_i_deg + 90));
    }
    return {fmt::format("{}as{}", theta_i_deg, aspecular_deg), theta_i_deg, aspecular_deg,
            std::abs(view_deg), view_deg >= 0 ? 180.0 : 0.0};
}

Geometry off_plane(double theta_i_deg, double aspecular_deg, double azimuth_deg) {
    require(theta_i_deg, kPolarAngleRange, "lamp in deg");
    require(aspecular_deg, {0, 180, "deg", false, true}, "aspecular angle");
    require(azimuth_deg, {-180, 180, "deg"}, "azimuth about the mirror direction");
    if (azimuth_deg == 0) return in_plane(theta_i_deg, -aspecular_deg);
    if (std::abs(azimuth_deg) == 180) return in_plane(theta_i_deg, aspecular_deg);
    if (aspecular_deg == 0) return in_plane(theta_i_deg, 0);
    // Components of the unit view direction: along the mirror direction, and across it away from
    // the normal and off the plane.
    const double along = std::cos(aspecular_deg * kDegree),
                 across = std::sin(aspecular_deg * kDegree),
                 away = across * std::cos(azimuth_deg * kDegree),
                 aside = across * std::sin(azimuth_deg * kDegree),
                 sine = std::sin(theta_i_deg * kDegree), cosine = std::cos(theta_i_deg * kDegree);
    const double x = -along * sine - away * cosine, z = along * cosine - away * sine;
    if (!(z > 1e-12)) {
        throw DomainError(fmt::format(
            "aspecular angle = {} deg, azimuth = {} deg: with the lamp at {} deg the view is below "
            "the horizon",
            aspecular_deg, azimuth_deg, theta_i_deg));
    }
    return {fmt::format("{}as{}az{}", theta_i_deg, aspecular_deg, azimuth_deg), theta_i_deg,
            aspecular_deg, std::atan2(std::hypot(x, aside), z) / kDegree,
            wrapped_deg(std::atan2(aside, x) / kDegree)};
}

Geometry towards(double theta_i_deg, double theta_o_deg, double phi_deg) {
    require(theta_i_deg, kPolarAngleRange, "lamp in deg");
    require(theta_o_deg, kPolarAngleRange, "theta of the view in deg");
    require(phi_deg, {-360, 360, "deg"}, "phi of the view");
    const double phi = wrapped_deg(phi_deg);
    if (phi == 180 || theta_o_deg == 0) return in_plane(theta_i_deg, theta_i_deg - theta_o_deg);
    if (phi == 0) return in_plane(theta_i_deg, theta_i_deg + theta_o_deg);
    return {fmt::format("{}to{},{}", theta_i_deg, theta_o_deg, phi), theta_i_deg,
            angle_deg(polar_direction(theta_o_deg, phi), specular_direction(theta_i_deg)),
            theta_o_deg, phi};
}

bool is_in_plane(const Geometry& geometry) {
    return geometry.theta_o_deg == 0 || geometry.phi_deg == 0 || geometry.phi_deg == 180;
}

double separation_deg(const Geometry& a, const Geometry& b) {
    return std::max(angle_deg(lamp(a), lamp(b)), angle_deg(view(a), view(b)));
}

// Names of geometries, as instruments and their exporters write them.

namespace {

/// Takes words and numbers off the front of a text.
class Words {
 public:
    explicit Words(std::string_view text) : rest_(text) {}

    bool take(std::string_view word) {
        if (rest_.size() < word.size()) return false;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const char c = rest_[i] >= 'A' && rest_[i] <= 'Z' ? rest_[i] - 'A' + 'a' : rest_[i];
            if (c != word[i]) return false;
        }
        rest_.remove_prefix(word.size());
        return true;
    }
    std::optional<double> take_number() {
        const double sign = take("minus") ? -1 : 1;
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return sign * value;
    }
    bool at_end() const { return rest_.empty(); }

 private:
    std::string_view rest_;
};

/// Lamp and what separates it from the aspecular angle: "45as", "45:as", "45/as", "45/", "as".
std::optional<double> take_lamp(Words& words) {
    const auto lamp = words.take_number();
    if (!lamp) return words.take("as") ? std::optional(kUsualLamp_deg) : std::nullopt;
    words.take("\u00b0");
    if (words.take(":as")) return lamp;
    const bool slash = words.take("/");
    return words.take("as") || slash ? lamp : std::nullopt;
}

std::optional<Geometry> by_aspecular_angle(Words words) {
    words.take("r");
    const auto lamp = take_lamp(words);
    const auto aspecular = lamp ? words.take_number() : std::nullopt;
    if (!aspecular) return std::nullopt;
    words.take("\u00b0");
    if (words.at_end()) return in_plane(*lamp, *aspecular);
    if (!words.take("az")) return std::nullopt;
    const auto azimuth = words.take_number();
    if (!azimuth || !words.at_end()) return std::nullopt;
    return off_plane(*lamp, *aspecular, *azimuth);
}

std::optional<Geometry> by_view(Words words) {
    words.take("r");
    const auto lamp = words.take_number();
    if (!lamp || !words.take("to")) return std::nullopt;
    const auto theta = words.take_number();
    if (!theta || !words.take(",")) return std::nullopt;
    const auto phi = words.take_number();
    if (!phi || !words.at_end()) return std::nullopt;
    return towards(*lamp, *theta, *phi);
}

}  // namespace

Geometry parse_geometry(std::string_view name) {
    if (name == "45/0") {
        throw DomainError(
            "'45/0' is the view along the normal to some and the mirror direction to others; write "
            "45as45 for the one, 45as0 for the other");
    }
    if (const auto geometry = by_aspecular_angle(Words(name))) return *geometry;
    if (const auto geometry = by_view(Words(name))) return *geometry;
    throw DomainError(fmt::format(
        "'{}' is no geometry; one is written 45as15 or 45as-15 (lamp and aspecular angle), "
        "45as25az90 (turned about the mirror direction) or 45to30,90 (theta and phi of the view)",
        excerpt(name)));
}

std::vector<Geometry> parse_geometries(std::string_view list) {
    std::vector<std::string> names;
    for (const std::string_view part : split(list, ',')) {
        // The comma of "45to30,90" separates theta and phi.
        if (!names.empty() && names.back().find("to") != std::string::npos &&
            names.back().find(',') == std::string::npos) {
            names.back() += "," + std::string(part);
        } else {
            names.emplace_back(part);
        }
    }
    std::vector<Geometry> geometries;
    std::set<std::string> seen;
    for (const std::string& name : names) {
        geometries.push_back(parse_geometry(name));
        if (!seen.insert(geometries.back().name).second) {
            throw DomainError(geometries.back().name + " appears twice");
        }
    }
    return geometries;
}

// The sets that are built in. Sources: docs/measure.md.

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
