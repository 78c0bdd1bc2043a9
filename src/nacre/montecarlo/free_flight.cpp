#include "nacre/montecarlo/free_flight.h"

#include <algorithm>
#include <cmath>

namespace nacre::montecarlo {
namespace {

/// One panel: rates at its start, middle and end.
struct Panel {
    double start, middle, end, width;

    double depth() const { return width / 6 * (start + 4 * middle + end); }

    /// Integral of the parabola over the fraction x of the panel.
    double depth_to(double x) const {
        const double linear = 4 * middle - 3 * start - end;
        const double square = 2 * (start + end - 2 * middle);
        return width * x * (start + x * (linear / 2 + x * square / 3));
    }
    double rate_at(double x) const {
        const double linear = 4 * middle - 3 * start - end;
        const double square = 2 * (start + end - 2 * middle);
        return start + x * (linear + x * square);
    }

    /// Fraction of the panel at which the integral is `target`, between 0 and depth(). Newton's
    /// method, with bisection where it would leave the bracket (a parabola through rates that fall
    /// to zero can dip below it).
    double invert(double target) const {
        constexpr int kMaxSteps = 60;
        constexpr double kPrecision = 1e-14;
        double low = 0, high = 1, x = target / depth();
        for (int step = 0; step < kMaxSteps; ++step) {
            const double miss = depth_to(x) - target;
            if (std::abs(miss) <= kPrecision * target) break;
            (miss < 0 ? low : high) = x;
            const double slope = width * rate_at(x);
            x = slope > 0 ? x - miss / slope : high;
            if (!(x > low && x < high)) x = (low + high) / 2;
        }
        return x;
    }
};

template <class Visit>
void for_each_panel(const Slab& slab, const RadialRay& ray, double length, int panels,
                    Visit&& visit) {
    const double width = length / panels;
    double start = candidate_rate(slab, ray.cosine);
    for (int i = 0; i < panels; ++i) {
        const double from = i * width;
        const Panel panel{start, candidate_rate(slab, ray.cosine_at(from + width / 2)),
                          candidate_rate(slab, ray.cosine_at(from + width)), width};
        if (!visit(panel, from)) return;
        start = panel.end;
    }
}

}  // namespace

double candidate_rate(const Slab& slab, double cosine) {
    double rate = slab.pigment_rate_per_um;
    for (const Flakes& species : slab.flakes)
        rate += species.area_density_per_um * candidate_area(cosine, species.alpha);
    return rate;
}

std::optional<Candidate> fly_delta(const Slab& slab, const RadialRay& ray, double length_um,
                                   RandomStream& random) {
    const double end = ray.cosine_at(length_um);
    const double majorant = candidate_rate(slab, std::max(std::abs(ray.cosine), std::abs(end)));
    if (!(majorant > 0)) return {};
    for (double distance = 0;;) {
        distance += random.exponential() / majorant;
        if (distance >= length_um) return {};
        const double choice = random.uniform() * majorant;
        if (choice < candidate_rate(slab, ray.cosine_at(distance)))
            return Candidate{distance, choice};
    }
}

std::optional<Candidate> fly_simpson(const Slab& slab, const RadialRay& ray, double length_um,
                                     int panels, RandomStream& random) {
    double target = random.exponential();
    std::optional<Candidate> found;
    for_each_panel(slab, ray, length_um, panels, [&](const Panel& panel, double from) {
        const double depth = panel.depth();
        if (target >= depth) {
            target -= depth;
            return true;
        }
        const double distance = from + panel.width * panel.invert(target);
        const double rate = candidate_rate(slab, ray.cosine_at(distance));
        found = Candidate{distance, random.uniform() * rate};
        return false;
    });
    return found;
}

double simpson_depth(const Slab& slab, const RadialRay& ray, double length_um, int panels) {
    double sum = 0;
    for_each_panel(slab, ray, length_um, panels, [&](const Panel& panel, double) {
        sum += panel.depth();
        return true;
    });
    return sum;
}

}  // namespace nacre::montecarlo
