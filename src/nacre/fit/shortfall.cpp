#include "nacre/fit/shortfall.h"

#include <algorithm>
#include <cmath>

#include "nacre/measure/measurement.h"
#include "nacre/spectra/lab.h"

namespace nacre::fit {

namespace {

constexpr double kMinFraction = 0.1;
constexpr double kMinDelta_e = 0.5;

/// A colour of another chroma; grey stays grey.
Vec3d with_chroma(const Vec3d& lab, double wanted) {
    const double chroma = measure::chroma(lab);
    if (chroma == 0) return lab;
    return {lab[0], lab[1] * wanted / chroma, lab[2] * wanted / chroma};
}

/// The difference that one attribute makes alone. Hues are compared at the geometric mean of both
/// chromas, as the formula does: what is nearly grey hardly differs in hue.
double delta_e_alone(const Vec3d& standard, const Vec3d& sample, Attribute attribute) {
    if (attribute == Attribute::lightness) {
        return spectra::delta_e_2000(standard, {sample[0], standard[1], standard[2]});
    }
    const double chroma = measure::chroma(standard), other = measure::chroma(sample);
    if (attribute == Attribute::chroma) {
        const Vec3d hue = chroma > 0 ? standard : Vec3d{standard[0], sample[1], sample[2]};
        return spectra::delta_e_2000(standard, with_chroma(hue, other));
    }
    const double mean = std::sqrt(chroma * other);
    return spectra::delta_e_2000(with_chroma(standard, mean),
                                 with_chroma({standard[0], sample[1], sample[2]}, mean));
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
        Shortfall one{.attribute = attribute, .fraction = 0, .angles = {}};
        for (const measure::AngleDifference& angle : difference.angles) {
            const double alone = delta_e_alone(angle.lab_standard, angle.lab_sample, attribute);
            one.fraction += angle.weight * alone * alone;
            if (alone >= kMinDelta_e && angle.weight > 0) {
                one.angles.push_back({&angle, delta_of(angle, attribute), alone});
            }
        }
        std::ranges::stable_sort(one.angles, std::ranges::greater(),
                                 &Shortfall::AtAngle::delta_e_2000);
        sum += one.fraction;
        all.push_back(std::move(one));
    }
    for (Shortfall& one : all) one.fraction = sum > 0 ? one.fraction / sum : 0;
    std::erase_if(all, [](const Shortfall& one) {
        return one.angles.empty() || one.fraction < kMinFraction;
    });
    std::ranges::stable_sort(all, std::ranges::greater(), &Shortfall::fraction);
    return all;
}

}  // namespace nacre::fit
