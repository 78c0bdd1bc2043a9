#include "nacre/io/version.h"

namespace nacre::io {

const char* version() { return NACRE_VERSION; }

}  // namespace nacre::io
