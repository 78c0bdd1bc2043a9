#pragma once

namespace nacre {

constexpr double square(double x) { return x * x; }

}  // namespace nacre
