#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

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
        : max_tables_(max_tables), max_cosines_(max_cosines) {}

    /// paint::FlakeTable::of_platelet(), computed or from the cache: the same bits.
    std::shared_ptr<const paint::FlakeTable> table(const optics::Platelet& platelet,
                                                   const optics::Material& binder,
                                                   const std::vector<double>& wavelengths_nm,
                                                   SharedProgress* work = nullptr);

    std::size_t computed() const;  ///< number of tables computed so far

 private:
    struct Entry {
        optics::Platelet platelet;
        optics::Material binder;
        std::vector<double> wavelengths_nm;
        std::shared_ptr<const paint::FlakeTable> table;
    };

    std::size_t max_tables_;
    int max_cosines_;
    mutable std::mutex mutex_;
    std::list<Entry> entries_;  // the last used one first
    std::size_t computed_ = 0;
};

}  // namespace nacre::solver
