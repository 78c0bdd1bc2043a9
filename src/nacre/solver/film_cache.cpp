#include "nacre/solver/film_cache.h"

namespace nacre::solver {

std::shared_ptr<const paint::FlakeTable> FilmCache::table(const optics::Platelet& platelet,
                                                          const optics::Material& binder,
                                                          const std::vector<double>& wavelengths_nm,
                                                          SharedProgress* work) {
    return tables_.get({platelet, binder, wavelengths_nm}, [&] {
        return paint::FlakeTable::of_platelet(platelet, binder, wavelengths_nm, max_cosines_, work);
    });
}

}  // namespace nacre::solver
