#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/io/file_kind.h"
#include "nacre/measure/geometry.h"

// Sets of geometries of one's own, as TOML:
//
//   name = "booth"
//   summary = "as we look at panels"        # optional
//
//   [[geometry]]                            # in the plane of incidence
//   lamp_deg = 45
//   aspecular_deg = 15
//
//   [[geometry]]                            # turned about the mirror direction
//   lamp_deg = 45
//   aspecular_deg = 25
//   azimuth_deg = 90
//
//   [[geometry]]                            # any view: theta and phi
//   lamp_deg = 45
//   view_deg = [30, 90]
//   name = "window"                         # optional; instruments' names otherwise

namespace nacre::io {

inline constexpr std::size_t kMaxGeometries = 10'000;

/// @throws InputError naming file, line, key, value and what is allowed: an unknown key, an angle
///         out of range, a view below the horizon, a name or a direction that appears twice, no
///         geometry
measure::GeometrySet parse_geometry_set(std::string_view text, const std::string& filename);
/// The same of a file that has been told apart, whatever it was found to be.
measure::GeometrySet parse_geometry_set(const TypedFile& file);
measure::GeometrySet read_geometry_set(const std::filesystem::path& path);

}  // namespace nacre::io
