#include "nacre/sparkle/facet_field.h"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/sparkle/lane_bits.h"

namespace nacre::sparkle {
namespace {

double whole_number_in_range(double count) {
    require_in_range(count, kFacetCountRange.lo, kFacetCountRange.hi, "number of facets");
    if (count != std::floor(count)) {
        throw DomainError(fmt::format("number of facets = {} is not a whole number", count));
    }
    return count;
}

double gamma_rad(double gamma_deg) {
    require_in_range(gamma_deg, kFacetConeRange.lo, kFacetConeRange.hi,
                     "half-angle of the query cone in deg");
    return gamma_deg * kDegree;
}

double checked_alpha(double alpha) {
    require_in_range(alpha, kFacetRoughnessRange.lo, kFacetRoughnessRange.hi,
                     "roughness alpha of the facets");
    return alpha;
}

}  // namespace

FacetField::FacetField(double count, double alpha, double gamma_deg, std::uint64_t seed)
    : count_(whole_number_in_range(count)),
      alpha_(checked_alpha(alpha)),
      alpha_f_(static_cast<float>(alpha)),
      seed_key_(mix_bits(seed + detail::kNextBits)),
      rule_(gamma_rad(gamma_deg), alpha),
      // Triangles about as large as the region of normals that a cone sees.
      normals_(std::make_shared<NormalTree>(alpha, gamma_rad(gamma_deg))) {
    leaf_level_ = 0;
    for (double n = count_; n > kMaxFacetsPerLeaf; n /= 4) ++leaf_level_;
    table_level_ = std::min(kTableLevel, leaf_level_);

    table_.resize(((std::uint64_t{1} << (2 * (table_level_ + 1))) - 1) / 3);
    table_[0] = static_cast<std::uint64_t>(count_);
    std::uint64_t* counts = table_.data();
    for (std::uint32_t level = 0; static_cast<int>(level) < table_level_; ++level) {
        const std::uint32_t side = 1u << level;
        std::uint64_t* below = counts + (std::uint64_t{1} << (2 * level));
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                for (const Cell& part : split({level, x, y, counts[y * side + x], false})) {
                    below[std::uint64_t{part.y} * 2 * side + part.x] = part.count;
                }
            }
        }
        counts = below;
    }
}

bool FacetField::is_explicit(const Footprint& footprint) const {
    const double cells = static_cast<double>(std::uint64_t{1} << leaf_level_);
    const Box& b = footprint.bounds();
    const double width = (b.u_hi - b.u_lo) * cells, height = (b.v_hi - b.v_lo) * cells;
    // A convex shape touches about as many cells as its area plus its half outline in cells.
    return footprint.area() * cells * cells + width + height <= kMaxLeaves;
}

FacetTally FacetField::count(const Footprint& footprint, Vec3f wi, Vec3f wo) const {
    FacetTally tally;
    if (!(footprint.area() > 0)) return tally;
    if (is_explicit(footprint)) {
        count_facets(footprint, {wi, wo, rule_.chord2()}, tally);
    } else {
        count_cells(footprint, wi, wo, tally);
    }
    return tally;
}

// Large footprints: cell by cell, triangle by triangle.

// The smallest triangles that the cone's normals lie in, in order, and the fraction of facets that
// are in both.
struct FacetField::Touched {
    static constexpr int kMax = 512;
    std::array<NormalTree::Code, kMax> code;
    std::array<float, kMax> fraction;
    int count = 0;

    void add(NormalTree::Code leaf, float mass) {
        // Nodes come ring by ring, so most are found near the end; there are a dozen or so.
        for (int i = 0; i < count; ++i) {
            if (code[i] == leaf) {
                fraction[i] += mass;
                return;
            }
        }
        // A cone up to 2 alpha wide has at most 480 nodes; of a wider one the region is two or
        // three triangles wide and at most 9 alpha / gamma < 5 long.
        if (count == kMax) throw std::logic_error("normals of a cone in too many triangles");
        code[count] = leaf;
        fraction[count++] = mass;
    }
    void sort() {
        for (int i = 1; i < count; ++i) {
            const NormalTree::Code c = code[i];
            const float s = fraction[i];
            int j = i;
            for (; j > 0 && code[j - 1] > c; --j) {
                code[j] = code[j - 1];
                fraction[j] = fraction[j - 1];
            }
            code[j] = c;
            fraction[j] = s;
        }
    }
};

// The level whose cells are a quarter to a half of the footprint's longer side. Footprints side by
// side share the cells at their border, which correlates their random deviations: the more, the
// larger the cells. Where the deviations are too small to be seen (at the peak an eighth of the
// facets reflect into the cone, say 4000, which vary by 1.6 %), cells are twice as large.
int FacetField::coarse_level(const Footprint& footprint) const {
    constexpr double kManyFacets = 3e4;
    const double across = count_ * footprint.area() < kManyFacets ? 4 : 2;
    const Box& b = footprint.bounds();
    const double side = std::max(b.u_hi - b.u_lo, b.v_hi - b.v_lo);
    return std::clamp(static_cast<int>(std::floor(std::log2(across / side))), 0, leaf_level_);
}

void FacetField::count_cells(const Footprint& footprint, Vec3f wi, Vec3f wo,
                             FacetTally& tally) const {
    // The same normals reflect wo into the cone about wi, and the count must be the same number.
    if (std::tie(wi.z, wi.x, wi.y) < std::tie(wo.z, wo.x, wo.y)) std::swap(wi, wo);
    Touched touched;
    rule_.visit(wi, wo, [&](FloatLanes x, FloatLanes y, FloatLanes z, FloatLanes fraction) {
        for (int i = 0; i < kLanes; ++i) {
            if (fraction[i] > 0) touched.add(normals_->locate({x[i], y[i], z[i]}), fraction[i]);
        }
    });
    touched.sort();

    std::uint64_t key = 0;
    for_each_cell(footprint, coarse_level(footprint), [&](const Cell& cell) {
        const Box box = cell.box();
        const double side = box.u_hi - box.u_lo;
        const double overlap =
            cell.inside ? 1.0 : std::min(1.0, footprint.shared_area(box) / (side * side));
        if (!(overlap > 0)) return;
        const std::uint64_t cell_key = mix_bits(key_of(cell) + 5 * detail::kNextBits);
        key ^= cell_key;
        const NormalTree::Parts octants = NormalTree::split_octants(cell.count, cell_key);
        int first = 0;
        for (std::uint32_t octant = 0; octant < 4; ++octant) {
            int last = first;
            while (last < touched.count &&
                   touched.code[last] >> (2 * normals_->depth()) == octant) {
                ++last;
            }
            if (last > first && octants.count[octant] > 0) {
                tally.count += count_node(touched, first, last, 0, 0, octants.count[octant],
                                          overlap, mix_bits(cell_key + 8 + octant));
            }
            first = last;
        }
    });
    while (tally.listed < FacetTally::kListed &&
           static_cast<std::uint64_t>(tally.listed) < tally.count) {
        key += detail::kNextBits;
        tally.thickness[tally.listed++] =
            to_unit_float(static_cast<std::uint32_t>(mix_bits(key) >> 32));
    }
}

std::uint64_t FacetField::count_node(const Touched& touched, int first, int last, int level,
                                     std::uint32_t node, std::uint64_t facets, double overlap,
                                     std::uint64_t key) const {
    const std::uint64_t node_key = mix_bits(key ^ node);
    if (level == normals_->depth()) {
        const double mass = normals_->mass(touched.code[first]);
        if (!(mass > 0)) return 0;
        // The cone rule is no exact measure of a triangle: it may find a little more than all of
        // one and less of its neighbours. Counting some twice then keeps the mean.
        const double expected = overlap * touched.fraction[first] / mass;
        const double times = std::floor(expected);
        return static_cast<std::uint64_t>(times) * facets +
               binomial(facets, expected - times, node_key);
    }
    const int shift = 2 * (normals_->depth() - level - 1);
    unsigned wanted = 0;
    for (int i = first; i < last; ++i) wanted |= 1u << ((touched.code[i] >> shift) & 3);
    const NormalTree::Parts parts = normals_->split(node, facets, node_key, wanted);
    std::uint64_t sum = 0;
    for (std::uint32_t part = 0; part < 4; ++part) {
        int end = first;
        while (end < last && ((touched.code[end] >> shift) & 3) == part) ++end;
        if (end > first && parts.count[part] > 0) {
            sum += count_node(touched, first, end, level + 1, 4 * node + 1 + part,
                              parts.count[part], overlap, key);
        }
        first = end;
    }
    return sum;
}

// Small footprints: facet by facet.

// Bounds on a facet's raw bits that hold for every normal in a cone: a ring and a sector of slopes
// about the half vector. Facets within them are tested exactly.
struct FacetField::NormalFilter {
    std::uint32_t survival_lo = 0, survival_range = 0;    // upper half: exp(-tan^2 / alpha^2)
    std::uint32_t turn_lo = 0, turn_range = 0xffffffffu;  // lower half: azimuth, wraps around
    bool empty = true;

    NormalFilter(const ReflectionCone& cone, double alpha) {
        // The bisector of wi and a direction at a chord c from wo is turned against that of wi and
        // wo by an angle of sine at most c / |wi + wo|.
        const Vec3f h = cone.wi + cone.wo;
        const double length2 = dot(h, h);
        const double sine_reach2 = cone.chord2 / length2 * 1.0001 + 1e-12;
        double sine_lo = 0, sine_hi = 1;
        if (h.z > 0 && sine_reach2 < 1) {
            const double sine_reach = std::sqrt(sine_reach2);
            const double cosine_reach = std::sqrt(1 - sine_reach2);
            const double sine2 = (static_cast<double>(h.x) * h.x + h.y * h.y) / length2;
            const double sine = std::sqrt(sine2), cosine = h.z / std::sqrt(length2);
            if (cosine > sine_reach) sine_hi = sine * cosine_reach + cosine * sine_reach;
            if (sine > sine_reach) {
                sine_lo = sine * cosine_reach - cosine * sine_reach;
                const double reach_turns = std::asin(sine_reach / sine) / (2 * std::numbers::pi);
                const double turn = std::atan2(h.y, h.x) / (2 * std::numbers::pi);
                const double lo = (turn - reach_turns) - std::floor(turn - reach_turns);
                turn_lo = static_cast<std::uint32_t>(lo * 0x1p32 - 0.5 * lo) - 64;
                turn_range = static_cast<std::uint32_t>(2 * reach_turns * 0x1p32) + 1024;
            }
        }
        const auto survival = [&](double s) {
            const double s2 = std::min(s * s, 1.0);
            return std::exp(-s2 / std::max(1 - s2, 1e-30) / (alpha * alpha)) * 0x1p32;
        };
        const double lo = std::floor(survival(sine_hi) * 0.9999) - 2;
        const double hi = std::ceil(survival(sine_lo) * 1.0001) + 2;
        empty = hi < 3;
        survival_lo = static_cast<std::uint32_t>(std::max(0.0, lo));
        survival_range = static_cast<std::uint32_t>(std::min(hi, 0x1p32 - 1)) - survival_lo;
    }
};

// Facets that passed the filter, tested eight at a time.
struct FacetField::Candidates {
    const ReflectionCone& cone;
    float alpha;
    FacetTally& tally;
    std::array<std::uint64_t, kLanes> bits;
    int count = 0;

    void add(std::uint64_t normal_bits) {
        bits[count++] = normal_bits;
        if (count == kLanes) test();
    }
    void test() {
        BitLanes normals{};
        for (int i = 0; i < count; ++i) normals[i] = bits[i];
        const SlopeLanes slopes = gaussian_slopes(normals);
        const auto in = cone.contains(alpha * slopes.x, alpha * slopes.y, splat(1.0f));
        for (int i = 0; i < count; ++i) {
            if (in[i]) tally.add(thickness_of(bits[i]));
        }
        count = 0;
    }
};

void FacetField::count_facets(const Footprint& footprint, const ReflectionCone& cone,
                              FacetTally& tally) const {
    const NormalFilter filter(cone, alpha_);
    if (filter.empty) return;
    Candidates candidates{cone, alpha_f_, tally, {}};
    for_each_cell(footprint, leaf_level_,
                  [&](const Cell& cell) { count_leaf(footprint, cell, filter, candidates); });
    candidates.test();
}

// Looks at eight facets at a time.
void FacetField::count_leaf(const Footprint& footprint, const Cell& cell,
                            const NormalFilter& filter, Candidates& candidates) const {
    constexpr std::uint64_t kLow = 0xffffffffu;
    constexpr BitLanes kNumber = {0, 1, 2, 3, 4, 5, 6, 7};
    const std::uint64_t key = key_of(cell);
    const Footprint::Within within = footprint.within(cell.box());
    for (std::uint64_t first = 0; first < cell.count; first += kLanes) {
        const BitLanes number = first + kNumber;
        const BitLanes place = mix_bits(key + (number + 4) * detail::kNextBits);
        const BitLanes bits = mix_bits(place + detail::kNextBits);
        auto pass = (number < cell.count) &
                    ((bits >> 32) - filter.survival_lo <= std::uint64_t{filter.survival_range}) &
                    ((((bits & kLow) - filter.turn_lo) & kLow) <= std::uint64_t{filter.turn_range});
        if (!cell.inside) {
            const DoubleLanes u = __builtin_convertvector(place >> 32, DoubleLanes) * 0x1p-32;
            const DoubleLanes v = __builtin_convertvector(place & kLow, DoubleLanes) * 0x1p-32;
            pass &= within.contains(u, v);
        }
        for_each_set_lane(__builtin_convertvector(pass, LaneMask),
                          [&](int lane) { candidates.add(bits[lane]); });
    }
}

}  // namespace nacre::sparkle
