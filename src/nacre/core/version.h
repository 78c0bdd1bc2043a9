#pragma once

namespace nacre {

/// Version of Nacre as MAJOR.MINOR.PATCH, written into the files it makes.
const char* version();

}  // namespace nacre
