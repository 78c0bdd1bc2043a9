#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

// Only for tests: counts what a program allocates. Replaces operator new of the whole program, so
// that only one file of it may include this.

namespace nacre::test {

inline std::atomic<long> allocations = 0;

}  // namespace nacre::test

// Not inlined: GCC would see free() given what it takes for the library's new (-Wmismatched-new-delete).
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++nacre::test::allocations;
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
