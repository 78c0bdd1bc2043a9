#include "nacre/render/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/core/lane_math.h"

namespace nacre::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

CompiledRectangle compile(const RectangleLight& light, EmissionBasis& basis) {
    CompiledRectangle r;
    r.normal = normalize(light.target_mm - light.center_mm);
    const Vec3f right = normalize(cross(light.up, r.normal));
    const Vec3f up = cross(r.normal, right);
    r.edge_u_mm = static_cast<float>(light.width_mm) * right;
    r.edge_v_mm = static_cast<float>(light.height_mm) * up;
    r.corner_mm = light.center_mm - 0.5f * (r.edge_u_mm + r.edge_v_mm);
    r.area_mm2 = static_cast<float>(light.width_mm * light.height_mm);
    r.radiance = static_cast<float>(light.radiance.scale);
    r.spectrum = basis.add(unit_illuminant(light.radiance.illuminant));
    r.visible = light.visible;
    return r;
}

CosineSine<float> turned_by(float turns) {
    const float angle = 2 * std::numbers::pi_v<float> * turns;
    return {std::cos(angle), std::sin(angle)};
}
CosineSine<FloatLanes> turned_by(const FloatLanes& turns) { return cos_sin_turns(turns); }

/// Cells of LightSet::colours_ along each side of the square.
constexpr int kColourCells = 32;

std::vector<EnvironmentRadiance::Coefficients> colours_of(const EnvironmentRadiance& environment) {
    using Coefficients = EnvironmentRadiance::Coefficients;
    constexpr int kSide = 4, kPoints = kColourCells * kSide;
    std::vector<Coefficients> sums(kColourCells * kColourCells);
    Coefficients all{};
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const int column = i % kPoints, row = i / kPoints;
        const Coefficients here = environment.coefficients(DirectionDistribution::from_square(
            Vec2f{(column + 0.5f) / kPoints, (row + 0.5f) / kPoints}));
        Coefficients& cell = sums[row / kSide * kColourCells + column / kSide];
        for (std::size_t k = 0; k < here.size(); ++k) {
            cell[k] += here[k];
            all[k] += here[k];
        }
    }
    // Where no light was found there may be some beside it: of the mean's colour.
    const Coefficients white = environment.white();
    const auto per_luminance = [&](Coefficients sum) {
        if (!(environment.luminance_of(sum) > 0)) sum = all;
        const float luminance = environment.luminance_of(sum);
        if (!(luminance > 0)) return white;
        for (std::size_t k = 0; k < sum.size(); ++k) {
            // A little white, so that no wavelength is left out that a detail may have.
            constexpr float kMin = 0.05f;
            sum[k] /= luminance;
            sum[k] += kMin * (white[k] - sum[k]);
        }
        return sum;
    };
    const Coefficients mean = per_luminance(all);
    for (Coefficients& cell : sums) cell = per_luminance(cell);
    const bool even = std::all_of(sums.begin(), sums.end(), [&](const Coefficients& cell) {
        constexpr float kRounding = 1e-4f;
        for (std::size_t k = 0; k < cell.size(); ++k) {
            if (std::abs(cell[k] - mean[k]) > kRounding * std::abs(mean[0])) return false;
        }
        return true;
    });
    return even ? std::vector{mean} : sums;
}

double disk_solid_angle(const DistantDisk& disk) { return std::numbers::pi * disk.chord_squared; }

}  // namespace

LightSet::LightSet(const std::vector<Light>& lights, const std::optional<Environment>& environment,
                   Vec3f center_mm, float radius_mm, EmissionBasis& basis) {
    double peaks_estimate = 0;
    if (environment) {
        CompiledEnvironment compiled = compile_environment(*environment, basis);
        environment_ = std::move(compiled.radiance);
        std::vector<float> luminance = DirectionDistribution::tabulated(
            compiled.table_columns, compiled.table_rows,
            [this](Vec3f d) { return environment_->luminance(d); });
        const DirectionDistribution& all =
            alone_.environment.emplace(compiled.table_columns, compiled.table_rows, luminance);
        const float mean = all.mean_brightness();
        add(Kind::environment, 0, std::numbers::pi * mean);
        constexpr float kMinOverMean = 1e-3f;
        min_brightness_ = mean > 0 ? kMinOverMean * mean : 1.0f;
        colours_ = colours_of(*environment_);
        for (float& y : luminance) y = std::max(0.0f, y - mean);
        const DirectionDistribution& peaks =
            beside_.environment.emplace(compiled.table_columns, compiled.table_rows, luminance);
        // What is left of an even sky is rounding.
        constexpr float kMin = 1e-4f;
        if (peaks.mean_brightness() > kMin * mean) {
            peaks_estimate = std::numbers::pi * peaks.mean_brightness();
            beside_.dimmest = mean;
        } else {
            beside_.environment.reset();
        }
        if (compiled.detail > 0)
            cells_.emplace(*environment_, compiled.detail, compiled.picture_width,
                           compiled.picture_height);
        sun_ = compiled.sun;
        if (sun_) add(Kind::sun, 0, sun_->luminance * disk_solid_angle(*sun_));
    }
    for (const Light& light : lights) {
        if (const auto* area = std::get_if<RectangleLight>(&light)) {
            const CompiledRectangle r = compile(*area, basis);
            // At least the scene's radius, so that the estimate of a light inside is finite.
            const float distance = std::max(length(area->center_mm - center_mm), radius_mm);
            add(Kind::rectangle, static_cast<int>(rectangles_.size()),
                r.radiance * r.area_mm2 / (distance * distance));
            rectangles_.push_back(r);
        } else {
            const auto& directional = std::get<DirectionalLight>(light);
            add(Kind::directional, static_cast<int>(directionals_.size()),
                directional.irradiance.scale);
            directionals_.push_back(
                {normalize(directional.to_light), static_cast<float>(directional.irradiance.scale),
                 basis.add(unit_illuminant(directional.irradiance.illuminant))});
        }
    }
    for (Entry entry : alone_.entries) {
        if (entry.kind == Kind::environment) {
            entry.probability = static_cast<float>(peaks_estimate);
        }
        if (entry.probability > 0) beside_.entries.push_back(entry);
    }
    normalise(alone_);
    normalise(beside_);
}

void LightSet::add(Kind kind, int index, double estimate) {
    // Black lights are never sampled.
    if (estimate > 0) alone_.entries.push_back({kind, index, static_cast<float>(estimate), 0});
}

void LightSet::normalise(Choice& choice) const {
    // A tenth of the probability is uniform: the estimate may be far off for a given point.
    constexpr double kEvenFraction = 0.1;
    double total = 0;
    for (const Entry& e : choice.entries) total += e.probability;
    double sum = 0;
    choice.rectangle_probability.assign(rectangles_.size(), 0);
    for (Entry& e : choice.entries) {
        const double p = (1 - kEvenFraction) * e.probability / total +
                         kEvenFraction / static_cast<double>(choice.entries.size());
        sum += p;
        e.probability = static_cast<float>(p);
        e.cumulative = static_cast<float>(sum);
        if (e.kind == Kind::environment) choice.environment_probability = e.probability;
        if (e.kind == Kind::sun) {
            choice.sun = {e.probability, static_cast<float>(1 / disk_solid_angle(*sun_))};
        }
        if (e.kind == Kind::rectangle) choice.rectangle_probability[e.index] = e.probability;
    }
    if (!choice.entries.empty()) choice.entries.back().cumulative = 1;
}

FloatLanes LightSet::escaped_spread(Vec3f direction, float solid_angle,
                                    const FloatLanes* basis) const {
    FloatLanes sum{};
    if (environment_) {
        const auto* mean = cells_ ? cells_->spread(direction, solid_angle) : nullptr;
        sum +=
            mean ? environment_->combined(*mean, basis) : environment_->radiance(direction, basis);
    }
    if (sun_) {
        const float chord_squared =
            std::max(sun_->chord_squared, solid_angle / std::numbers::pi_v<float>);
        const Vec3f off = direction - sun_->direction;
        if (dot(off, off) <= chord_squared) {
            sum += (sun_->chord_squared / chord_squared) * sun_radiance(basis);
        }
    }
    return sum;
}

std::optional<LightSample> LightSet::sample(Vec3f point_mm, float u_light, Vec2f u,
                                            const FloatLanes* basis, bool alone) const {
    const Choice& choice = this->choice(alone);
    if (choice.entries.empty()) return std::nullopt;
    const Entry& entry = choice.entries[choice.entry_at(u_light)];
    const LightDirection<float> found = draw(choice, entry, point_mm, u);
    if (!(found.pdf > 0)) return std::nullopt;
    return LightSample{found, radiance_of(entry, found.direction, basis)};
}

LightDirections LightSet::directions(Vec3f point_mm, FloatLanes u_light, Vec2<FloatLanes> u,
                                     const FloatLanes* basis, bool alone) const {
    LightDirections found;
    const Choice& choice = this->choice(alone);
    if (choice.entries.empty()) return found;
    if (choice.entries.size() == 1) {
        const Entry& only = choice.entries[0];
        static_cast<LightDirection<FloatLanes>&>(found) = draw(choice, only, point_mm, u);
        found.brightness *= sum_per_luminance(only, found.direction, basis);
        return found;
    }
    for (int k = 0; k < kLanes; ++k) found.light[k] = choice.entry_at(u_light[k]);
    for (int entry = 0; entry < static_cast<int>(choice.entries.size()); ++entry) {
        const IntLanes here = found.light == entry;
        if (!any(here)) continue;
        const LightDirection<FloatLanes> light = draw(choice, choice.entries[entry], point_mm, u);
        const auto put = [&](auto& to, const auto& from) { to = here ? from : to; };
        put(found.direction.x, light.direction.x);
        put(found.direction.y, light.direction.y);
        put(found.direction.z, light.direction.z);
        put(found.distance, light.distance);
        put(found.pdf, light.pdf);
        put(found.density, light.density);
        put(found.brightness,
            light.brightness * sum_per_luminance(choice.entries[entry], light.direction, basis));
        put(found.delta, light.delta);
    }
    return found;
}

LightSample LightSet::look_at(const LightDirections& eight, int lane, const FloatLanes* basis,
                              bool alone) const {
    const LightDirection<float> found{nacre::lane(eight.direction, lane),
                                      eight.distance[lane],
                                      eight.pdf[lane],
                                      eight.density[lane],
                                      eight.brightness[lane],
                                      eight.delta[lane] != 0};
    return {found, radiance_of(choice(alone).entries[eight.light[lane]], found.direction, basis)};
}

template <class T>
LightDirection<T> LightSet::draw(const Choice& choice, const Entry& entry, Vec3f point_mm,
                                 const Vec2<T>& u) const {
    const auto all = [](float x) { return T{} + x; };
    using Mask = decltype(T{} < T{});
    switch (entry.kind) {
        case Kind::environment: {
            const DirectionSample<T> s = choice.environment->sample(u);
            return {.direction = s.direction,
                    .distance = all(kInfinity),
                    .pdf = choice.environment_probability * s.pdf,
                    .density = s.pdf,
                    .brightness = choice.dimmest + s.brightness};
        }
        case Kind::sun: {
            const T drop = 0.5f * sun_->chord_squared * u.x;  // 1 - cos
            const T sine = sqrt_lanes(max_lanes(drop * (2 - drop), T{}));
            const CosineSine<T> turn = turned_by(u.y);
            const Frame frame = Frame::around(sun_->direction);
            const T x = sine * turn.cosine, y = sine * turn.sine, z = 1 - drop;
            return {.direction = {x * frame.s.x + y * frame.t.x + z * frame.n.x,
                                  x * frame.s.y + y * frame.t.y + z * frame.n.y,
                                  x * frame.s.z + y * frame.t.z + z * frame.n.z},
                    .distance = all(kInfinity),
                    .pdf = all(choice.sun.value()),
                    .density = all(choice.sun.density),
                    .brightness = all(static_cast<float>(sun_->luminance))};
        }
        case Kind::rectangle: {
            const CompiledRectangle& r = rectangles_[entry.index];
            const Vec3f from = r.corner_mm - point_mm;
            const T x = from.x + u.x * r.edge_u_mm.x + u.y * r.edge_v_mm.x,
                    y = from.y + u.x * r.edge_u_mm.y + u.y * r.edge_v_mm.y,
                    z = from.z + u.x * r.edge_u_mm.z + u.y * r.edge_v_mm.z;
            const T distance = sqrt_lanes(x * x + y * y + z * z), inverse = 1 / distance;
            const Vec3<T> direction{x * inverse, y * inverse, z * inverse};
            const T density = density_over(r, direction, distance);
            // None of a point of the light itself, nor edge on.
            const T pdf = entry.probability * density;
            return {direction, distance,        pdf < kInfinity ? pdf : T{},
                    density,   all(r.radiance), r.visible ? Mask{} : distance == distance};
        }
        case Kind::directional: {
            const Directional& d = directionals_[entry.index];
            return {{all(d.direction.x), all(d.direction.y), all(d.direction.z)},
                    all(kInfinity),
                    all(entry.probability),
                    all(kInfinity),
                    all(d.irradiance),
                    T{} == T{}};
        }
    }
    return {};
}

FloatLanes LightSet::radiance_of(const Entry& entry, Vec3f direction,
                                 const FloatLanes* basis) const {
    switch (entry.kind) {
        case Kind::environment:
            return environment_->radiance(direction, basis);
        case Kind::sun:
            return sun_radiance(basis);
        case Kind::rectangle:
            return rectangle_radiance(entry.index, basis);
        case Kind::directional: {
            const Directional& d = directionals_[entry.index];
            return d.irradiance * basis[d.spectrum];
        }
    }
    return FloatLanes{};
}

FloatLanes LightSet::common_colour(const FloatLanes* basis) const {
    FloatLanes least = splat(kInfinity);
    const auto add = [&](const FloatLanes& colour) {
        if (lane_max(colour) > 0) least = min_lanes(least, colour);  // what is black sends nothing
    };
    for (const auto& cell : colours_) add(environment_->combined(cell, basis));
    if (sun_) add(sun_radiance(basis) / static_cast<float>(sun_->luminance));
    for (const CompiledRectangle& light : rectangles_) add(basis[light.spectrum]);
    return least[0] < kInfinity ? max_lanes(least, FloatLanes{}) : FloatLanes{};
}

FloatLanes LightSet::sum_per_luminance(const Entry& entry, const Vec3Lanes& direction,
                                       const FloatLanes* basis) const {
    switch (entry.kind) {
        case Kind::environment: {
            const auto sum = [&](std::size_t cell) {
                return lane_sum(environment_->combined(colours_[cell], basis));
            };
            if (colours_.size() == 1) return splat(sum(0));
            const Vec2<FloatLanes> square = DirectionDistribution::to_square(direction);
            const auto along = [](const FloatLanes& u) {
                return min_lanes(whole(u * static_cast<float>(kColourCells)),
                                 IntLanes{} + (kColourCells - 1));
            };
            const IntLanes cell = along(square.y) * kColourCells + along(square.x);
            return make_lanes([&](int k) { return sum(static_cast<std::size_t>(cell[k])); });
        }
        case Kind::sun:
            return splat(lane_sum(sun_radiance(basis)) / static_cast<float>(sun_->luminance));
        case Kind::rectangle:
            return splat(lane_sum(basis[rectangles_[entry.index].spectrum]));
        case Kind::directional:
            return splat(lane_sum(basis[directionals_[entry.index].spectrum]));
    }
    return FloatLanes{};
}

}  // namespace nacre::render
