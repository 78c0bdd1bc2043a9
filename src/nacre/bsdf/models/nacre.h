#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/flake_films.h"
#include "nacre/bsdf/model.h"
#include "nacre/bsdf/models/bound_microflake.h"
#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/solver/solved_paint.h"
#include "nacre/sparkle/flake_field.h"

namespace nacre::bsdf {

/// Chooses the model Nacre.
struct NacreModel {
    std::uint64_t specimen = 0;  ///< which panel of the batch: the seed of its flakes and its coat
    /// Large flakes: light that has come in between the flakes finds the same gaps on its way out
    /// (HotSpotTables). Without it the mean is that of the solver, exactly.
    bool hot_spot = true;

    static constexpr std::string_view kName = "nacre";  ///< its alternatives' as well
    static const ModelInfo info;
    std::shared_ptr<const Bsdf> make(const ModelInput& input, const Progress& progress) const;
    std::string text() const;
    std::shared_ptr<const Bsdf> make_mean(std::shared_ptr<const solver::SolvedPaint> paint,
                                          const Progress& progress) const;
    bool makes_arrays() const { return true; }
    std::shared_ptr<NacreArrays> make_arrays(
        const std::shared_ptr<const solver::SolvedPaint>& paint, ArrayParts parts,
        const Progress& progress) const;
    bool shows_hot_spot() const { return hot_spot; }

    friend bool operator==(const NacreModel&, const NacreModel&) = default;
};

/// The micro-flake model with single flakes: colour travel, sparkle and multiple scattering at
/// once.
///
/// Single scattering is a sum over the flakes of the patch that is looked at, each with its own
/// place, size, slope, depth and films (sparkle/flake_field.h); the interface and multiple
/// scattering are those of Microflake, with the hot spot of large flakes. Without a patch it is the
/// mean over all patches, exactly; without the hot spot that is Microflake. A patch is read from
/// Patch::footprint, in millimetres; which flakes there are depends on the specimen alone.
/// [docs/nacre-model.md]
///
/// Under a binder whose index depends on the wavelength, which flakes reflect is decided with the
/// mean index; the mean of each wavelength stays its own.
class Nacre final : public Bsdf, public SingleFlakes {
 public:
    /// @throws DomainError if the paint's flakes are outside the range of FlakeField
    /// @throws Stopped if `progress`, which is asked while films are computed, says so
    explicit Nacre(std::shared_ptr<const solver::SolvedPaint> paint,
                   const NacreModel& settings = {}, const Progress& progress = {});
    /// A surface for its mean alone, bit for bit that of the whole, in a fraction of the time: it has
    /// neither the films of single flakes nor, unless they lean, tables to sample by: eval() alone may be
    /// called, or bind_with_lean()'s.
    /// @throws as the constructor
    static std::shared_ptr<const Nacre> mean_alone(std::shared_ptr<const solver::SolvedPaint> paint,
                                                   const NacreModel& settings = {},
                                                   const Progress& progress = {});
    ~Nacre() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    SurfaceCoordinates surface_coordinates() const override {
        return SurfaceCoordinates::object_space;
    }
    double exact_patch_mm() const override;
    const sparkle::CoatWaves* coat_waves() const override { return waves_ ? &*waves_ : nullptr; }
    const sparkle::CoatThickness* coat_thickness() const override {
        return thickness_ ? &*thickness_ : nullptr;
    }
    std::optional<Vec2f> flake_lean() const override { return lean_; }

    struct Tables;
    const Tables& tables() const { return *tables_; }

 private:
    enum class Wanted { all, mean };
    Nacre(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
          const Progress& progress, Wanted wanted);

    std::shared_ptr<const Tables> tables_;
    std::optional<sparkle::CoatWaves> waves_;
    std::optional<sparkle::CoatThickness> thickness_;
    std::optional<Vec2f> lean_;
};

// What the nacre model works out once a paint.

/// One kind of flakes in one layer.
struct NacreSpecies {
    static constexpr int kMaxDirections = 8;
    sparkle::FlakeField field;
    std::shared_ptr<const FlakeFilms> films;  ///< null: all alike
    float fraction;  ///< flake_fractions(): the probability with which its flakes are sampled
    int directions;  ///< that are drawn from the lobe of a typical flake
};
/// How finely to tabulate the films of single flakes.
struct FlakeFilmGrid {
    std::vector<double> wavelengths_nm;
    int cosine_intervals = FlakeFilms::kCosineIntervals;
};
using SpeciesFilms = std::vector<std::shared_ptr<const FlakeFilms>>;
/// Of all kinds of flakes, layer by layer; null: all alike. Species of one kind share theirs.
/// @param work  asked while films are computed, where it is not null
/// @throws DomainError, Stopped as FlakeFilms
SpeciesFilms species_films(const solver::SolvedPaint& paint, const FlakeFilmGrid& grid,
                           SharedProgress* work = nullptr);
/// Of all layers of a panel, layer by layer.
/// @param films  species_films()
/// @throws DomainError as flake_fields()
std::vector<NacreSpecies> nacre_species(const Microflake::Tables& tables, std::uint64_t specimen,
                                        const SpeciesFilms& films);

/// The flakes of all layers of a panel, layer by layer.
/// @throws DomainError if they are outside the range of FlakeField
std::vector<sparkle::FlakeField> flake_fields(const Microflake::Tables& tables,
                                              std::uint64_t specimen);
/// Fraction of all singly scattered light at normal incidence that each kind of flakes in each layer
/// reflects, roughly. They add up to 1.
std::vector<float> flake_fractions(const Microflake::Tables& tables);

struct Nacre::Tables {
    Tables(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
           Wanted wanted, SharedProgress& work);

    std::optional<HotSpotTables> hot_spot;
    std::shared_ptr<Microflake::Tables> smooth;  ///< under a rough clearcoat with the hot spot
    std::vector<NacreSpecies> species;           ///< layer by layer
    std::vector<std::size_t> first_species;      ///< of each layer
    /// Of a smooth coat whose thickness varies, at the nodes of CoatSpread.
    std::vector<HotSpotTables> hot_spot_nodes;
};

// The nacre model at eight wavelengths.

class BoundNacre final : public BoundMicroflake {
 public:
    BoundNacre(std::shared_ptr<const Nacre::Tables> tables, const Wavelengths& wavelengths);

    // The mean over all patches: that of BoundMicroflake, but for a hot spot.
    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    MultiplyScattered multiply_scattered(Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;

    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float u_select,
                                        Vec2f u) const override;
    std::size_t patch_memory_bytes() const override {
        return 2 * tables_->species.size() * sizeof(sparkle::FlakeView);
    }
    bool samples_flakes() const override { return true; }
    UnitRange interface_lobe_range(const Patch* patch, Vec3f wi) const override;
    float narrow_light_pdf(Vec3f wi) const override;
    CoatChange coat_change(Vec3f wi, Vec3f wo, float deviation) const override;
    void sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                       std::vector<FlakeSamples>& list) const override;
    FloatLanes flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& flake) const override;
    FloatLanes flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const override;

 private:
    class WithHotSpot;
    class FlakesOfPatch;
    class BackgroundFlakes;
    class SomeFlakes;
    class AllOfSpecies;

    // The flakes of a patch, by species: in its memory or, where it has none, in one of its own.
    class PatchFlakes {
     public:
        PatchFlakes(const BoundNacre& surface, const Patch& patch, Vec3f wi);
        const sparkle::FlakeView& operator[](std::size_t species) const { return views_[species]; }

     private:
        PatchMemory own_;
        const sparkle::FlakeView* views_;
    };

    // Probability of the ways to sample a patch, in proportion to the light that they are expected
    // to find on it; with those of single flakes they add up to 1.
    struct Probability {
        SamplingProbabilities lobes;
        float flakes;       // all resolved
        float per_species;  // times NacreSpecies::fraction times weight_sum: those of one species
    };
    Probability probability_on(const PatchFlakes& views, const Ray& i) const;
    std::optional<Vec3f> draw_flake(const PatchFlakes& views, const Probability& probability,
                                    const Ray& i, float u_flake, Vec2f u) const;
    // Per solid angle outside, of draw_flake().
    float flake_density(const PatchFlakes& views, const Probability& probability, const Ray& i,
                        const Ray& o) const;
    FloatLanes value_on(const Patch& patch, const PatchFlakes& views, const Ray& i,
                        const Ray& o) const;
    // Of one flake and what lies above it in its layer, with its films over their mean.
    FloatLanes relative_attenuation(std::size_t species, std::size_t layer,
                                    const sparkle::FlakeView& view, int flake, float cosine,
                                    const FloatLanes& depth, const HotSpot::Pair* pair) const;
    // The same of eight flakes.
    void relative_attenuations(std::size_t species, std::size_t layer,
                               const sparkle::FlakeView& view, const IntLanes& flakes,
                               const FloatLanes& cosine, const FloatLanes& depth,
                               const HotSpot::Pair* pair,
                               std::array<FloatLanes, kLanes>& attenuations) const;
    // Approximate luminance that flakes of one species reflect from w_i up into w_o, for sampling: at
    // even steps of sqrt(1 - cos theta) outside, which are nearly even angles.
    struct MeanFlakeReflectance {
        static constexpr int kEyeIntervals = 12, kIntervals = kLanes - 1;  // of w_i, and of w_o
        using ByEye = std::array<FloatLanes, kEyeIntervals + 1>;
        static float cosine(int node, int intervals) {
            const float x = static_cast<float>(node) / static_cast<float>(intervals);
            return std::max(1 - x * x, 0.02f);
        }
        /// Between the nodes of tables by cosine: one place, or eight.
        template <class Cosine>
        struct Place {
            decltype(whole(Cosine{})) node;
            Cosine fraction;
            Place(const Cosine& cosine, int intervals) {
                const Cosine x =
                    static_cast<float>(intervals) * sqrt_lanes(max_lanes(1 - cosine, Cosine{}));
                node = min_lanes(whole(x), whole(Cosine{}) + (intervals - 1));
                fraction = x - to_float(node);
            }
            FloatLanes in(const ByEye& table) const {
                return table[node] + fraction * (table[node + 1] - table[node]);
            }
            /// Of a table whose nodes are lanes.
            FloatLanes in(const FloatLanes& table) const {
                const FloatLanes before = sparkle::pick_lanes(table, node);
                return before + fraction * (sparkle::pick_lanes(table, node + 1) - before);
            }
        };
        /// By cosine of w_i, with nothing in its layer above the flake, for w_o of typical_reflected().
        ByEye light{};
        /// By cosines of w_i and, in lanes, of w_o: with what lies above the mean flake, over that for that w_o.
        ByEye relative{};
    };
    // The direction into which a flake mirrors w_i that leans by the median slope, across the plane
    // of w_i and the normal. If that light does not leave the coat: the direction of a flake that
    // lies flat. The hot-spot factor of that direction is close to its average over flakes.
    Ray typical_reflected(std::size_t species, const Ray& i) const;
    MeanFlakeReflectance mean_flake_reflectance(std::size_t species) const;
    // Per solid angle outside, of directions spread over the lobe of a typical flake that mirrors
    // wi upwards.
    float slope_density(std::size_t species, Vec3f wi) const;
    // Number per solid angle outside of the directions that sample_flakes() draws for the flake.
    // @param directions  of this flake in all: DirectionCounts
    float flake_pdf(const sparkle::FlakeView& view, float directions, std::size_t species,
                    int flake, const Ray& i, const Ray& o) const;
    FloatLanes mean_value(const Ray& i, const Ray& o) const;

    std::shared_ptr<const Nacre::Tables> tables_;
    std::vector<BoundFlakeFilms> films_;  // by species
    std::optional<HotSpot> hot_spot_;
    std::vector<HotSpot> hot_spot_nodes_;
    FloatLanes eye_{};                                          // response_of_eye()
    std::vector<MeanFlakeReflectance> mean_flake_reflectance_;  // by species
};

}  // namespace nacre::bsdf
