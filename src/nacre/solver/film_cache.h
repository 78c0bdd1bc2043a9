#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/core/lru_cache.h"
#include "nacre/optics/thin_film.h"
#include "nacre/paint/flake_table.h"

namespace nacre::solver {

/// Keeps the R and T tables of platelets, a fifth to five sixths of the time of a solve, for
/// callers that solve a recipe many times with other amounts, layers or orientations. May be used
/// from several threads at once; drops the least recently used table.
class FilmCache {
 public:
    /// @param max_cosines  see paint::FlakeTable::of_platelet()
    explicit FilmCache(std::size_t max_tables = 64,
                       int max_cosines = paint::FlakeTable::kMaxCosines)
        : max_cosines_(max_cosines), tables_(max_tables) {}

    /// paint::FlakeTable::of_platelet(), computed or from the cache: the same bits.
    std::shared_ptr<const paint::FlakeTable> table(const optics::Platelet& platelet,
                                                   const optics::Material& binder,
                                                   const std::vector<double>& wavelengths_nm,
                                                   SharedProgress* work = nullptr);

    std::size_t computed() const { return tables_.made(); }  ///< number of tables so far

 private:
    struct Film {
        optics::Platelet platelet;
        optics::Material binder;
        std::vector<double> wavelengths_nm;
        friend bool operator==(const Film&, const Film&) = default;
    };

    int max_cosines_;
    LruCache<Film, paint::FlakeTable> tables_;
};

}  // namespace nacre::solver
