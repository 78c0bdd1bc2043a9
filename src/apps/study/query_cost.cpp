#include "apps/study/query_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"

namespace nacre::study {
namespace {

constexpr bsdf::Wavelengths kWavelengths_nm = {418, 456, 493, 531, 568, 606, 643, 681};

Vec3f hemisphere(float z, float phi) {
    const float s = std::sqrt(1 - z * z);
    return {s * std::cos(phi), s * std::sin(phi), z};
}

float turn(Rng& rng) { return 2 * std::numbers::pi_v<float> * rng.uniform_float(); }

}  // namespace

std::vector<bsdf::Patch> square_patches(double area_mm2, double fraction, int count) {
    require_in_range(area_mm2, 1e-12, 1e6, "area of a patch in mm2");
    require_in_range(fraction, 1e-18, 0.25, "fraction of the unit square");
    constexpr float kRadius_mm = 50;
    const auto side_mm = static_cast<float>(std::sqrt(area_mm2));
    const double side = std::sqrt(fraction), room = std::max(0.0, 1 - std::numbers::sqrt2 * side);
    std::vector<bsdf::Patch> patches;
    Rng rng(4, 2);
    while (static_cast<int>(patches.size()) < count) {
        const float z = 2 * rng.uniform_float() - 1;
        const Vec3f normal = hemisphere(z, turn(rng));
        const Frame frame = Frame::around(normal);
        const float angle = turn(rng), c = std::cos(angle), s = std::sin(angle);
        bsdf::Patch patch;
        // Wholly within the unit square, whichever way it is turned.
        patch.u = 0.5 + room * (rng.uniform_double() - 0.5);
        patch.v = 0.5 + room * (rng.uniform_double() - 0.5);
        const auto edge = static_cast<float>(side);
        patch.edge_1 = {edge * c, edge * s};
        patch.edge_2 = {-edge * s, edge * c};
        patch.footprint = {
            kRadius_mm * normal,
            normal,
            frame.s,
            {side_mm * (c * frame.s + s * frame.t), side_mm * (c * frame.t - s * frame.s)}};
        patches.push_back(patch);
    }
    return patches;
}

QuerySubject::QuerySubject(const bsdf::Bsdf& surface, int queries)
    : bound_(surface.bind(kWavelengths_nm)) {
    require_in_range(queries, 1, 1 << 20, "number of queries");
    Rng rng(1, 1);
    while (static_cast<int>(queries_.size()) < queries) {
        Query q;
        q.wi = hemisphere(std::sqrt(1 - rng.uniform_float()), turn(rng));
        q.u_select = rng.uniform_float();
        q.u = {rng.uniform_float(), rng.uniform_float()};
        const auto sample = bound_->sample(q.wi, q.u_select, q.u);
        // The specular lobe has no value to ask for.
        if (!sample || sample->kind != bsdf::SampleKind::density) continue;
        q.wo = sample->wo;
        queries_.push_back(q);
    }
}

QueryCost QuerySubject::measure(const std::vector<bsdf::Patch>& patches, QueryKind what) const {
    if (!patches.empty() && patches.size() != queries_.size()) {
        throw DomainError(fmt::format("{} patches for {} queries: must be as many, or none",
                                      patches.size(), queries_.size()));
    }
    // So few that what is kept about them stays in the cache, as that of one path does.
    constexpr std::size_t kKept = 64;
    const bool again = what == QueryKind::repeated_value;
    const std::size_t kept = again ? std::min(kKept, patches.size()) : 1;
    std::vector<bsdf::PatchMemory> memories(kept, bsdf::PatchMemory(bound_->patch_memory_bytes()));
    std::vector<bsdf::Patch> places = patches;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (again) places[i] = patches[i % kept];
        places[i].memory = &memories[i % kept];
        if (again) bound_->evaluate_on(places[i], queries_[i].wi, queries_[i].wo);
    }
    FloatLanes sum{};
    // Used, so that the compiler keeps it, and too small to change the mean.
    const auto use = [&](const std::optional<bsdf::BsdfSample>& sample) {
        if (sample) sum += 1e-9f * sample->weight;
    };
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < queries_.size(); ++i) {
        const Query& q = queries_[i];
        if (places.empty()) {
            sum += bound_->evaluate(q.wi, q.wo).f;
            if (what == QueryKind::value_and_sample) use(bound_->sample(q.wi, q.u_select, q.u));
            continue;
        }
        if (!again) places[i].memory->forget();
        sum += bound_->evaluate_on(places[i], q.wi, q.wo).f;
        if (what == QueryKind::value_and_sample) {
            use(bound_->sample_on(places[i], q.wi, q.u_select, q.u));
        }
    }
    const double time_ns = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto count = static_cast<double>(queries_.size());
    return {time_ns / count, lane_mean(sum) / count};
}

}  // namespace nacre::study
