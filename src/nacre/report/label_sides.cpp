#include "nacre/report/label_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/report/plot_frame.h"

namespace nacre::report {

namespace {

constexpr int kSides = 8;

Pixel normal(Pixel before, Pixel after) {
    const Pixel d{after.x - before.x, after.y - before.y};
    const double length = std::hypot(d.x, d.y);
    return length > 0 ? Pixel{d.y / length, -d.x / length} : Pixel{0.7, -0.7};
}

}  // namespace

Pixel side_direction(int side) {
    const double angle = side * 2 * std::numbers::pi / kSides;
    return {std::cos(angle), std::sin(angle)};
}

std::vector<int> label_sides(std::span<const Pixel> points) {
    const std::size_t n = points.size();
    std::vector<Pixel> normals;
    for (std::size_t i = 0; i < n; ++i) {
        normals.push_back(normal(points[i > 0 ? i - 1 : 0], points[std::min(i + 1, n - 1)]));
    }
    // Which way the curve bends, summed along it: labels stand on the other side.
    double bend = 0, upwards = 0;
    for (std::size_t i = 0; i < n; ++i) {
        upwards += normals[i].x - normals[i].y;
        if (i == 0 || i + 1 == n) continue;
        bend += (points[i - 1].x + points[i + 1].x - 2 * points[i].x) * normals[i].x +
                (points[i - 1].y + points[i + 1].y - 2 * points[i].y) * normals[i].y;
    }
    const double sign = std::abs(bend) > 1 ? (bend > 0 ? -1 : 1) : (upwards < 0 ? -1 : 1);
    std::vector<int> sides;
    for (const Pixel& direction : normals) {
        const double angle = std::atan2(sign * direction.y, sign * direction.x);
        const auto eighth = std::lround(angle / (2 * std::numbers::pi / kSides));
        sides.push_back(static_cast<int>((eighth + kSides) % kSides));
    }
    return sides;
}

std::vector<int> label_sides(const Plot& plot, const Extents& ends, const Series& series) {
    // A picture of usual shape: how large it will be is not known yet.
    const Box box{0, 0, 640,
                  plot.equal_scale ? 640 * (ends.y.hi - ends.y.lo) / (ends.x.hi - ends.x.lo) : 360};
    const PlotFrame frame(plot, ends, box);
    std::vector<int> sides(series.x.size(), -1);
    std::vector<Pixel> pixels;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!can_be_shown(plot, series.x[i], series.y[i])) continue;
        pixels.push_back(frame.at(series.x[i], series.y[i]));
        shown.push_back(i);
    }
    const std::vector<int> of_shown = label_sides(pixels);
    for (std::size_t k = 0; k < shown.size(); ++k) sides[shown[k]] = of_shown[k];
    if (labels_only_its_end(series) && sides.back() >= 0) sides.back() = 0;
    return sides;
}

bool labels_only_its_end(const Series& series) {
    const auto& labels = series.point_labels;
    return labels.size() > 1 && std::all_of(labels.begin(), labels.end() - 1,
                                            [](const std::string& text) { return text.empty(); });
}

}  // namespace nacre::report
