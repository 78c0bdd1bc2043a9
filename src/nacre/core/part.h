#pragma once

namespace nacre {

/// Part of the light that a paint returns: `single` met exactly one flake or pigment particle, and
/// neither the substrate nor the inner side of the interface; `multiple` is all other light that
/// entered the paint. The specular reflection of a smooth interface belongs to none of them, the
/// lobe of a rough one to the total alone.
///
/// Solver and random walks, which check each other and share no code, mean the same by it.
enum class Part { total, single, multiple };

}  // namespace nacre
