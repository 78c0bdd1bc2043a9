#pragma once

#include <stdexcept>

namespace nacre::cli {

/// The command line is wrong in a way that only the command itself can see. Exit status 1.
class UsageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace nacre::cli
