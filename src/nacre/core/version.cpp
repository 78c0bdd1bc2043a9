#include "nacre/core/version.h"

namespace nacre {

const char* version() { return NACRE_VERSION; }

}  // namespace nacre
