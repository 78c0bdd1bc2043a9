#include "nacre/fit/shortfall.h"

#include <algorithm>
#include <cmath>

#include "nacre/measure/measurement.h"
#include "nacre/spectra/lab.h"

namespace nacre::fit {

namespace {

constexpr double kLeastShare = 0.1;
constexpr double kLeastDelta_e = 0.5;

/// The standard's colour but for one attribute, which is the sample's.
Vec3d with_attribute(const Vec3d& standard, const Vec3d& sample, Attribute attribute) {
    if (attribute == Attribute::lightness) return {sample[0], standard[1], standard[2]};
    const double chroma = std::hypot(standard[1], standard[2]),
                 wanted = std::hypot(sample[1], sample[2]);
    if (attribute == Attribute::hue) {  // grey has no hue to take over
        if (wanted == 0) return standard;
        return {standard[0], sample[1] * chroma / wanted, sample[2] * chroma / wanted};
    }
    if (chroma == 0) return {standard[0], sample[1], sample[2]};
    return {standard[0], standard[1] * wanted / chroma, standard[2] * wanted / chroma};
}

double delta_of(const measure::AngleDifference& angle, Attribute attribute) {
    if (attribute == Attribute::lightness) return angle.delta_lab[0];
    return attribute == Attribute::chroma ? angle.delta_chroma() : angle.delta_hue();
}

}  // namespace

std::vector<Shortfall> shortfalls(const measure::Difference& difference) {
    std::vector<Shortfall> all;
    double sum = 0;
    for (const Attribute attribute : {Attribute::lightness, Attribute::chroma, Attribute::hue}) {
        Shortfall one{attribute};
        for (const measure::AngleDifference& angle : difference.angles) {
            const double alone = spectra::delta_e_2000(
                angle.lab_standard,
                with_attribute(angle.lab_standard, angle.lab_sample, attribute));
            one.share += angle.weight * alone * alone;
            if (alone >= kLeastDelta_e && angle.weight > 0) {
                one.angles.push_back({&angle, delta_of(angle, attribute), alone});
            }
        }
        std::ranges::stable_sort(one.angles, std::ranges::greater(),
                                 &Shortfall::AtAngle::delta_e_2000);
        sum += one.share;
        all.push_back(std::move(one));
    }
    for (Shortfall& one : all) one.share = sum > 0 ? one.share / sum : 0;
    std::erase_if(
        all, [](const Shortfall& one) { return one.angles.empty() || one.share < kLeastShare; });
    std::ranges::stable_sort(all, std::ranges::greater(), &Shortfall::share);
    return all;
}

}  // namespace nacre::fit
