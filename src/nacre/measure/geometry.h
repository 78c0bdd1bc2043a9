#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

// Directions of lamp and detector: the geometries of multi-angle spectrophotometers. The lamp's
// azimuth is 0; phi = 180 deg is the mirror side.

namespace nacre::measure {

/// Where the lamp is if a name does not say it: that of all multi-angle instruments.
inline constexpr double kUsualLamp_deg = 45;

/// One pair of lamp and detector.
struct Geometry {
    std::string name;           ///< as instruments print it: "45as15"
    double theta_i_deg = 45;    ///< of the lamp, [0, 90)
    double aspecular_deg = 15;  ///< between the view and the mirror direction; in the plane of
                                ///< incidence signed, positive towards the normal, else >= 0
    double theta_o_deg = 30;    ///< of the view, [0, 90)
    double phi_deg = 180;       ///< phi_o - phi_i of the view, [0, 360)

    friend bool operator==(const Geometry&, const Geometry&) = default;
};

/// In the plane of incidence: the signed angle of view is theta_i - aspecular, positive on the
/// mirror side. Its name is "45as15", "45as-15".
/// @throws DomainError naming the angle if theta_i is outside [0, 90) or the view below the horizon
Geometry in_plane(double theta_i_deg, double aspecular_deg);

/// Off the plane: from the mirror direction by `aspecular_deg` in [0, 180), turned about it by
/// `azimuth_deg` in [-180, 180], 0 being away from the normal and 180 towards it; a positive turn
/// leads to phi < 180. Its name is "45as25az90"; in the plane it is that of in_plane().
/// @throws DomainError as in_plane()
Geometry off_plane(double theta_i_deg, double aspecular_deg, double azimuth_deg);

/// Any view. Its name is that of in_plane() where it lies in the plane of incidence, else
/// "45to30,90" (lamp, theta and phi of the view).
/// @throws DomainError as in_plane()
Geometry towards(double theta_i_deg, double theta_o_deg, double phi_deg);

/// The geometry that such a name stands for: "45as15", "45as-15", "45as25az90" or "45to30,90", as
/// exporters of instruments write them also with "r" before or "Minus" for "-", capitals or not, as
/// "45/15" or "45:as15", or without the lamp, as "as15", where it is at 45 deg.
/// @throws DomainError naming the text if it is none of these, or as in_plane()
Geometry parse_geometry(std::string_view name);

/// A list of them, as "45as15,45as25az90,45to30,90".
/// @throws DomainError as parse_geometry(); naming a geometry that appears twice
std::vector<Geometry> parse_geometries(std::string_view list);

/// Whether the view lies in the plane of the lamp and the normal.
bool is_in_plane(const Geometry& geometry);

/// The larger of the angles between the two lamps and between the two views, deg.
double separation_deg(const Geometry& a, const Geometry& b);

struct GeometrySet {
    std::string name;     ///< as on the command line
    std::string summary;  ///< in one line, with its source
    std::vector<Geometry> geometries;

    friend bool operator==(const GeometrySet&, const GeometrySet&) = default;
};

/// The set that is taken where none is named.
inline constexpr const char* kDefaultGeometries = "byk-mac";

/// The sets that are built in: docs/measure.md has their sources.
std::span<const GeometrySet> geometry_sets();
/// Null if there is none of that name.
const GeometrySet* find_geometry_set(std::string_view name);

}  // namespace nacre::measure
