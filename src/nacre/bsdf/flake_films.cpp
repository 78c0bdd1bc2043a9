#include "nacre/bsdf/flake_films.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/lru_cache.h"
#include "nacre/core/random.h"
#include "nacre/optics/thickness_rule.h"

namespace nacre::bsdf {
namespace {

/// Which of `count` (a power of two) equally probable ranges of thickness each flake of the set
/// takes for the film number `film` among those that vary.
std::vector<int> strata(int film, int count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    if (film == 1) {
        // With the index it makes the Hammersley set.
        for (int i = 0; i < count; ++i) {
            order[i] = static_cast<int>(count * radical_inverse(i, 2));
        }
    } else if (film > 1) {
        Rng rng(static_cast<std::uint64_t>(film), count);
        for (int i = count - 1; i > 0; --i) {
            std::swap(order[i], order[static_cast<int>((i + 1) * rng.uniform_double())]);
        }
    }
    return order;
}

bool varies(const optics::FilmPopulation& film) { return film.spread.standard_deviation_nm > 0; }

}  // namespace

std::vector<std::vector<double>> representative_thicknesses_nm(const optics::Platelet& platelet) {
    std::vector<const optics::FilmPopulation*> films = {&platelet.core};
    for (const optics::FilmPopulation& coat : platelet.coats) films.push_back(&coat);
    const auto varying =
        std::ranges::count_if(films, [](const auto* film) { return varies(*film); });
    const int count = varying == 0   ? 1
                      : varying == 1 ? FlakeFilms::kOneFilmSet
                                     : FlakeFilms::kManyFilmsSet;
    std::vector<std::vector<double>> set(count);
    int film = 0;
    for (const optics::FilmPopulation* law : films) {
        const std::vector<int> order = varies(*law) ? strata(film++, count) : std::vector<int>{};
        for (int i = 0; i < count; ++i) {
            set[i].push_back(varies(*law)
                                 ? optics::thickness_quantile(law->thickness_nm, law->spread,
                                                              (order[i] + 0.5) / count)
                                 : law->thickness_nm);
        }
    }
    return set;
}

bool FlakeFilms::vary(const optics::Platelet& platelet) {
    return varies(platelet.core) ||
           std::any_of(platelet.coats.begin(), platelet.coats.end(), varies);
}

FlakeFilms::FlakeFilms(const optics::Platelet& platelet, const optics::Material& binder,
                       std::span<const double> wavelengths_nm, double min_cosine,
                       SharedProgress* work, int cosine_intervals)
    : intervals_(cosine_intervals), stride_(wavelengths_nm.size() + 1), min_cosine_(min_cosine) {
    require_in_range(min_cosine, 0, 1 - 1e-6, "least cosine of the incidence on a flake");
    const std::vector<std::vector<double>> set = representative_thicknesses_nm(platelet);
    sets_ = set.size();
    std::vector<double> cosines;
    for (int c = 0; c <= intervals_; ++c) {
        cosines.push_back(
            std::min(1.0, std::lerp(min_cosine, 1.0, c / static_cast<double>(intervals_))));
    }
    const auto reflectance =
        optics::platelet_reflectances(platelet, set, binder, cosines, wavelengths_nm, work);
    const std::size_t values = cosines.size() * stride_;
    ratio_.reserve(sets_ * values);
    for (auto row = reflectance.begin(); row != reflectance.end();) {
        const auto end = row + static_cast<std::ptrdiff_t>(stride_ - 1);
        for (; row != end; ++row) ratio_.push_back(static_cast<float>(*row));
        ratio_.push_back(ratio_.back());
    }
    std::vector<double> mean(values, 0.0);
    for (std::size_t i = 0; i < sets_; ++i) {
        for (std::size_t v = 0; v < values; ++v) mean[v] += ratio_[i * values + v];
    }
    for (double& m : mean) m /= static_cast<double>(sets_);
    for (std::size_t i = 0; i < sets_; ++i) {
        for (std::size_t v = 0; v < values; ++v) {
            float& r = ratio_[i * values + v];
            // At grazing incidence, or where indices match, all may be 0.
            r = mean[v] > 0 ? static_cast<float>(r / mean[v]) : 1.0f;
        }
    }
    alike_ = std::ranges::all_of(ratio_, [](float r) { return std::abs(r - 1) < kAlike; });
}

std::shared_ptr<const FlakeFilms> flake_films(const optics::Platelet& platelet,
                                              const optics::Material& binder,
                                              std::span<const double> wavelengths_nm,
                                              double min_cosine, SharedProgress* work,
                                              int cosine_intervals) {
    struct Films {
        optics::Platelet platelet;
        optics::Material binder;
        std::vector<double> wavelengths_nm;
        double min_cosine;
        int cosine_intervals;
        bool operator==(const Films&) const = default;
    };
    static LruCache<Films, FlakeFilms> films(std::size_t{64} << 20, [](const FlakeFilms& f) {
        return f.ratios().size() * sizeof(float);
    });
    return films.get({platelet,
                      binder,
                      {wavelengths_nm.begin(), wavelengths_nm.end()},
                      min_cosine,
                      cosine_intervals},
                     [&] {
                         return FlakeFilms(platelet, binder, wavelengths_nm, min_cosine, work,
                                           cosine_intervals);
                     });
}

BoundFlakeFilms FlakeFilms::bind(const std::array<WavelengthPosition, kLanes>& where) const {
    BoundFlakeFilms out;
    out.sets_ = sets_;
    out.min_cosine_ = static_cast<float>(min_cosine_);
    out.intervals_ = intervals_;
    out.per_cosine_ = static_cast<float>(intervals_ / (1 - min_cosine_));
    out.ratio_.resize(sets_ * static_cast<std::size_t>(intervals_ + 1));
    const FloatLanes fraction = make_lanes([&](int i) { return where[i].fraction; });
    for (std::size_t i = 0; i < out.ratio_.size(); ++i) {
        const float* row = ratio_.data() + i * stride_;
        const FloatLanes low = make_lanes([&](int l) { return row[where[l].lower]; });
        const FloatLanes high = make_lanes([&](int l) { return row[where[l].lower + 1]; });
        out.ratio_[i] = low + fraction * (high - low);
    }
    return out;
}

}  // namespace nacre::bsdf
