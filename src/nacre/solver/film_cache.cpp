#include "nacre/solver/film_cache.h"

#include <algorithm>

namespace nacre::solver {

std::shared_ptr<const paint::FlakeTable> FilmCache::table(const optics::Platelet& platelet,
                                                          const optics::Material& binder,
                                                          const std::vector<double>& wavelengths_nm,
                                                          SharedProgress* work) {
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
            return entry.platelet == platelet && entry.wavelengths_nm == wavelengths_nm &&
                   entry.binder == binder;
        });
        if (found != entries_.end()) {
            entries_.splice(entries_.begin(), entries_, found);
            return found->table;
        }
    }
    // Unlocked meanwhile: two threads may compute the same table, with the same bits.
    auto table = std::make_shared<const paint::FlakeTable>(
        paint::FlakeTable::of_platelet(platelet, binder, wavelengths_nm, max_cosines_, work));
    const std::lock_guard lock(mutex_);
    entries_.push_front({platelet, binder, wavelengths_nm, table});
    if (entries_.size() > max_tables_) entries_.pop_back();
    ++computed_;
    return table;
}

std::size_t FilmCache::computed() const {
    const std::lock_guard lock(mutex_);
    return computed_;
}

}  // namespace nacre::solver
