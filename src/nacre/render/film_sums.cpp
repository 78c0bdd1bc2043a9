#include "nacre/render/film_sums.h"

namespace nacre::render {

namespace {

template <class T>
void add_each(std::vector<T>& sums, const std::vector<T>& others) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if constexpr (requires { sums[i].add(others[i]); }) {
            sums[i].add(others[i]);
        } else {
            sums[i] += others[i];
        }
    }
}

}  // namespace

void PassSums::add(const PassSums& other) {
    count += other.count;
    d65.add(other.d65);
    albedo_d65.add(other.albedo_d65);
    add_each(bin_weights, other.bin_weights);
}

FilmSums::FilmSums(int w, int h, int spectral_bins, bool with_sparkle) : width(w), height(h) {
    passes.bin_weights.resize(static_cast<std::size_t>(spectral_bins));
    xyz.resize(pixels());
    albedo.resize(pixels());
    if (with_sparkle) sparkle.resize(pixels());
    normal.resize(pixels());
    met.resize(pixels());
    invalid.resize(pixels());
    spectral.resize(pixels() * static_cast<std::size_t>(spectral_bins));
}

void FilmSums::add(const FilmSums& other) {
    passes.add(other.passes);
    add_each(xyz, other.xyz);
    add_each(albedo, other.albedo);
    add_each(sparkle, other.sparkle);
    add_each(normal, other.normal);
    add_each(met, other.met);
    add_each(invalid, other.invalid);
    add_each(spectral, other.spectral);
}

}  // namespace nacre::render
