#pragma once

#include <cstring>

#include "nacre/core/lanes.h"

// Eight numbers as registers of the machine, for inner loops: GCC keeps sums of vectors that are wider than
// a register in memory.

namespace nacre::solver {

inline constexpr int kRegisterLanes = kRegisterBytes / sizeof(double);
using Register = double __attribute__((vector_size(kRegisterLanes * sizeof(double))));

/// Of eight numbers.
inline constexpr int kRegisters = kLanes / kRegisterLanes;

inline Register load(const DoubleLanes* from, int part) {
    Register r;
    std::memcpy(&r, reinterpret_cast<const char*>(from) + part * sizeof r, sizeof r);
    return r;
}
/// A number that all lanes share.
inline Register load(const double* from, int /*part*/) { return *from - Register{}; }
inline void store(const Register& r, DoubleLanes* to, int part) {
    std::memcpy(reinterpret_cast<char*>(to) + part * sizeof r, &r, sizeof r);
}

}  // namespace nacre::solver
