#include "nacre/bsdf/flake_films.h"

#include <algorithm>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/rng.h"
#include "nacre/optics/thickness_rule.h"

namespace nacre::bsdf {
namespace {

constexpr int kSets = FlakeFilms::kSets, kRow = FlakeFilms::kCosineIntervals + 1;

/// Which of kSets equal shares of its law each flake of the set takes for its film number `film`
/// among those that vary.
std::vector<int> strata(int film) {
    std::vector<int> order(kSets);
    std::iota(order.begin(), order.end(), 0);
    if (film == 1) {
        // Bits in reverse: the radical inverse, which with the index makes the Hammersley set.
        for (int i = 0; i < kSets; ++i) {
            order[i] = 0;
            for (int bit = 1; bit < kSets; bit *= 2) order[i] = 2 * order[i] + ((i & bit) != 0);
        }
    } else if (film > 1) {
        Rng rng(static_cast<std::uint64_t>(film), kSets);
        for (int i = kSets - 1; i > 0; --i) {
            std::swap(order[i], order[static_cast<int>((i + 1) * rng.uniform_double())]);
        }
    }
    return order;
}

}  // namespace

std::vector<optics::Platelet> representative_platelets(const optics::Platelet& platelet) {
    std::vector<optics::Platelet> set(kSets, platelet);
    int varying = 0;
    const auto fix = [&](const optics::FilmPopulation& law, auto&& film_of) {
        if (law.spread.standard_deviation_nm == 0) return;
        const std::vector<int> order = strata(varying++);
        for (int i = 0; i < kSets; ++i) {
            film_of(set[i]) = {
                law.material,
                optics::thickness_quantile(law.thickness_nm, law.spread, (order[i] + 0.5) / kSets),
                {}};
        }
    };
    fix(platelet.core, [](optics::Platelet& p) -> optics::FilmPopulation& { return p.core; });
    for (std::size_t c = 0; c < platelet.coats.size(); ++c) {
        fix(platelet.coats[c],
            [c](optics::Platelet& p) -> optics::FilmPopulation& { return p.coats[c]; });
    }
    return set;
}

bool FlakeFilms::vary(const optics::Platelet& platelet) {
    const auto varies = [](const optics::FilmPopulation& film) {
        return film.spread.standard_deviation_nm > 0;
    };
    return varies(platelet.core) ||
           std::any_of(platelet.coats.begin(), platelet.coats.end(), varies);
}

FlakeFilms::FlakeFilms(const optics::Platelet& platelet, const optics::Material& binder,
                       std::span<const double> wavelengths_nm, double least_cosine)
    : wavelength_count_(static_cast<int>(wavelengths_nm.size())), least_cosine_(least_cosine) {
    require_in_range(least_cosine, 0, 1 - 1e-6, "least cosine of the incidence on a flake");
    const std::vector<optics::Platelet> set = representative_platelets(platelet);
    std::vector<double> cosines(kRow);
    for (int c = 0; c < kRow; ++c) {
        cosines[c] = std::min(1.0, std::lerp(least_cosine, 1.0, c / (kRow - 1.0)));
    }
    const std::size_t values = static_cast<std::size_t>(kRow) * wavelength_count_;
    ratio_.resize(kSets * values);
    parallel_for(0, kSets, [&](std::size_t i) {
        const auto table = optics::platelet_table(set[i], binder, cosines, wavelengths_nm);
        std::copy(table.reflectance.begin(), table.reflectance.end(), ratio_.begin() + i * values);
    });
    parallel_for(0, values, [&](std::size_t v) {
        double mean = 0;
        for (int i = 0; i < kSets; ++i) mean += ratio_[i * values + v];
        mean /= kSets;
        for (int i = 0; i < kSets; ++i) {
            float& r = ratio_[i * values + v];
            // At grazing incidence, or where indices match, there may be nothing to share out.
            r = mean > 0 ? static_cast<float>(r / mean) : 1.0f;
        }
    });
}

BoundFlakeFilms FlakeFilms::bind(const std::array<Between, kLanes>& where) const {
    BoundFlakeFilms out;
    out.least_cosine_ = static_cast<float>(least_cosine_);
    out.per_cosine_ = static_cast<float>(kCosineIntervals / (1 - least_cosine_));
    out.ratio_.resize(static_cast<std::size_t>(kSets) * kRow);
    for (std::size_t i = 0; i < out.ratio_.size(); ++i) {
        const float* row = ratio_.data() + i * wavelength_count_;
        out.ratio_[i] = at_wavelengths(where, [&](int w) { return row[w]; });
    }
    return out;
}

}  // namespace nacre::bsdf
