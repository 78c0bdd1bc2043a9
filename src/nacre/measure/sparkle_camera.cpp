#include "nacre/measure/sparkle_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/bsdf/local_coat.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/memory.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/sparkle/coat_waves.h"
#include "nacre/spectra/xyz.h"

namespace nacre::measure {
namespace {

constexpr Vec3f kView{0, 0, 1};
constexpr double kMaxTotalPixels = 6e7;  // 720 MB
// Spacing of directions to a lamp: a quarter of the radius of the lobe of a flake of 100 um.
constexpr double kLampSpacing_deg = 0.1;
// Rows between two calls of `progress`.
constexpr int kRowsAtOnce = 16;
constexpr const char* kTaking = "taking the pictures";

// The two sets of eight wavelengths are interleaved, so that each spans the visible range.
constexpr int kOctets = 2, kWavelengths = kOctets * kLanes;
constexpr double kFirst_nm = 400, kStep_nm = 20;
constexpr double wavelength_nm(int octet, int lane) {
    return kFirst_nm + kStep_nm * (kOctets * lane + octet);
}

using Spectrum = std::array<FloatLanes, kOctets>;

// Weights of the wavelengths in X, Y and Z.
struct ColourWeights {
    std::array<Spectrum, 3> of;

    ColourWeights() {
        std::array<double, kWavelengths> wavelengths, one;
        for (int i = 0; i < kWavelengths; ++i) wavelengths[i] = kFirst_nm + kStep_nm * i;
        for (int i = 0; i < kWavelengths; ++i) {
            one.fill(0);
            one[i] = 1;
            const auto xyz = spectra::reflectance_to_xyz(wavelengths, one, spectra::Illuminant::D65,
                                                         spectra::Observer::cie1931_2deg);
            for (int c = 0; c < 3; ++c) {
                of[c][i % kOctets][i / kOctets] = static_cast<float>(xyz[c] / 100);
            }
        }
    }

    /// XYZ of a reflectance times `scale`.
    void store(const Spectrum& reflectance, float scale, float* xyz) const {
        for (int c = 0; c < 3; ++c) {
            FloatLanes sum{};
            for (int o = 0; o < kOctets; ++o) sum += of[c][o] * reflectance[o];
            xyz[c] = scale * lane_sum(sum);
        }
    }
};

struct LampDirection {
    Vec3f towards;
    float weight;  // pi times its fraction of the light on the panel
};

// Evenly over the disc, along the spiral of a sunflower.                            [vogel-1979]
std::vector<LampDirection> lamp_directions(double angle_deg, double half_angle_deg) {
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::pow(half_angle_deg / kLampSpacing_deg, 2))));
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    const double versine = 1 - std::cos(half_angle_deg * kDegree);
    const double tilt = angle_deg * kDegree;
    std::vector<LampDirection> directions;
    double light = 0;
    for (int i = 0; i < count; ++i) {
        const double cosine = 1 - versine * (i + 0.5) / count;
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const double x = sine * std::cos(golden_angle * i), y = sine * std::sin(golden_angle * i);
        const Vec3f towards{static_cast<float>(x * std::cos(tilt) + cosine * std::sin(tilt)),
                            static_cast<float>(y),
                            static_cast<float>(cosine * std::cos(tilt) - x * std::sin(tilt))};
        directions.push_back({towards, towards.z});
        light += towards.z;
    }
    for (LampDirection& d : directions) {
        d.weight = static_cast<float>(std::numbers::pi * d.weight / light);
    }
    return directions;
}

float fraction_of(double u) {
    return std::min(static_cast<float>(u - std::floor(u)), 0x1.fffffep-1f);
}

// Pixels are evaluated patch by patch, each so small that it resolves its flakes. On patches larger
// than that by this factor, each flake represents 1.002 flakes, far below the noise.
constexpr double kNearlyExact = 1.35;
constexpr int kMaxPatches = 16;  // per side of a pixel

double patches_wanted(const bsdf::Bsdf& surface, double pixel_mm) {
    const auto* const flakes = dynamic_cast<const bsdf::SingleFlakes*>(&surface);
    return flakes ? std::ceil(pixel_mm / (kNearlyExact * flakes->exact_patch_mm())) : 1;
}

class Photographer {
 public:
    Photographer(const bsdf::Bsdf& surface, const SparkleCamera& camera)
        : camera_(camera),
          across_(pixels_across(camera)),
          pixel_mm_(camera.field_mm / across_),
          waves_(surface.coat_waves()),
          unit_square_(surface.surface_coordinates() == bsdf::SurfaceCoordinates::unit_square),
          patches_(static_cast<int>(
              std::clamp(patches_wanted(surface, pixel_mm_), 1.0, double{kMaxPatches}))),
          exact_(patches_wanted(surface, pixel_mm_) <= kMaxPatches) {
        for (int o = 0; o < kOctets; ++o) {
            bsdf::Wavelengths wavelengths;
            for (int i = 0; i < kLanes; ++i) wavelengths[i] = wavelength_nm(o, i);
            bound_[o] = bsdf::bind_with_lean(surface, wavelengths);
        }
        for (double lamp : camera.lamps_deg) {
            lamps_.push_back(lamp_directions(lamp, camera.lamp_half_angle_deg));
        }
        // Hammersley's points, for each patch and each of the two pictures.
        const int half = std::max(1, camera.diffuse_samples / (2 * patches_ * patches_));
        for (int i = 0; i < half; ++i) {
            points_.push_back({(i + 0.5) / half, radical_inverse(i, 2), radical_inverse(i, 3)});
        }
    }

    PanelPicture blank() const {
        PanelPicture picture{across_, across_, pixel_mm_, {}};
        picture.xyz.resize(3 * picture.pixel_count());
        return picture;
    }
    int across() const { return across_; }
    bool exact() const { return exact_; }

    /// The working memory of one thread.
    struct Workspace {
        explicit Workspace(const Photographer& p)
            : memory(p.bound_[0]->patch_memory_bytes()), by_lamp(p.lamps_.size()) {}
        bsdf::PatchMemory memory;
        std::vector<Spectrum> by_lamp;
        std::array<Spectrum, 2> diffuse;
    };

    void expose(std::size_t pixel, Workspace& workspace, PanelPictures& pictures,
                SharedProgress& work) const {
        std::fill(workspace.by_lamp.begin(), workspace.by_lamp.end(), Spectrum{});
        workspace.diffuse.fill(Spectrum{});
        Rng rng(camera_.seed, pixel);
        for (int piece = 0; piece < patches_ * patches_; ++piece) {
            work.throw_if_stopped(kTaking);
            workspace.memory.forget();
            const bsdf::Patch patch = patch_of(pixel, piece, workspace.memory);
            const bsdf::CoatParameters place = place_of(patch);
            const Surfaces here{bsdf::LocalCoat(*bound_[0], place, kView),
                                bsdf::LocalCoat(*bound_[1], place, kView)};
            for (std::size_t lamp = 0; lamp < lamps_.size(); ++lamp) {
                add_lit(here, patch, lamps_[lamp], workspace.by_lamp[lamp], work);
            }
            if (pictures.diffuse.empty()) continue;
            for (Spectrum& half : workspace.diffuse) add_diffuse(here, patch, rng, half, work);
        }
        const float fraction = 1.0f / static_cast<float>(patches_ * patches_);
        for (std::size_t lamp = 0; lamp < lamps_.size(); ++lamp) {
            weights_.store(workspace.by_lamp[lamp], fraction,
                           &pictures.by_lamp[lamp].xyz[3 * pixel]);
        }
        const float fraction_of_points = fraction / static_cast<float>(points_.size());
        for (std::size_t half = 0; half < pictures.diffuse.size(); ++half) {
            weights_.store(workspace.diffuse[half], fraction_of_points,
                           &pictures.diffuse[half].xyz[3 * pixel]);
        }
    }

 private:
    using Surfaces = std::array<bsdf::LocalCoat, kOctets>;

    // Of a flat panel whose frame is that of its coordinates; the lean is part of bound_.
    bsdf::CoatParameters place_of(const bsdf::Patch& patch) const {
        if (!waves_) return {};
        const sparkle::ObjectSpaceFootprint& at = patch.footprint;
        return {.slope = waves_->slope(at.position_mm, at.normal, at.tangent)};
    }

    bsdf::Patch patch_of(std::size_t pixel, int piece, bsdf::PatchMemory& memory) const {
        const double side_mm = pixel_mm_ / patches_;
        const double middle = 0.5 * across_ * patches_ - 0.5;
        const auto column = static_cast<double>((pixel % across_) * patches_ + piece % patches_);
        const auto row = static_cast<double>((pixel / across_) * patches_ + piece / patches_);
        const double x = (column - middle) * side_mm, y = (middle - row) * side_mm;
        const auto side = static_cast<float>(side_mm);
        bsdf::Patch patch;
        patch.memory = &memory;
        patch.footprint = {{static_cast<float>(x), static_cast<float>(y), 0},
                           {0, 0, 1},
                           {1, 0, 0},
                           {{side, 0, 0}, {0, side, 0}}};
        if (unit_square_) {
            const auto fraction = static_cast<float>(side_mm / camera_.unit_square_mm);
            patch.u = 0.5 + x / camera_.unit_square_mm;
            patch.v = 0.5 + y / camera_.unit_square_mm;
            patch.edge_1 = {fraction, 0};
            patch.edge_2 = {0, fraction};
        }
        return patch;
    }

    void add_lit(const Surfaces& here, const bsdf::Patch& patch,
                 const std::vector<LampDirection>& lamp, Spectrum& sum,
                 SharedProgress& work) const {
        for (const LampDirection& d : lamp) {
            work.throw_if_stopped(kTaking);
            for (int o = 0; o < kOctets; ++o) {
                sum[o] += d.weight * here[o].surface().evaluate_on(patch, kView, d.towards).f;
            }
        }
    }

    void add_diffuse(const Surfaces& here, const bsdf::Patch& patch, Rng& rng, Spectrum& sum,
                     SharedProgress& work) const {
        const double shift[3] = {rng.uniform_double(), rng.uniform_double(), rng.uniform_double()};
        for (const auto& point : points_) {
            work.throw_if_stopped(kTaking);
            const auto sample = here[0].surface().sample_on(
                patch, kView, fraction_of(point[0] + shift[0]),
                {fraction_of(point[1] + shift[1]), fraction_of(point[2] + shift[2])});
            if (!sample || sample->kind != bsdf::SampleKind::density) continue;
            sum[0] += sample->weight;
            const float cosine_over_pdf = sample->wo.z / sample->pdf;
            for (int o = 1; o < kOctets; ++o) {
                sum[o] +=
                    cosine_over_pdf * here[o].surface().evaluate_on(patch, kView, sample->wo).f;
            }
        }
    }

    const SparkleCamera& camera_;
    int across_;
    double pixel_mm_;
    const sparkle::CoatWaves* waves_;  // null: the coat is flat
    bool unit_square_;
    int patches_;  // per side of a pixel
    bool exact_;
    std::array<std::unique_ptr<const bsdf::BoundBsdf>, kOctets> bound_;
    std::vector<std::vector<LampDirection>> lamps_;
    std::vector<std::array<double, 3>> points_;
    ColourWeights weights_;
};

// Copies the first pixel to all others.
void spread_first(PanelPicture& picture) {
    for (std::size_t i = 3; i < picture.xyz.size(); ++i) picture.xyz[i] = picture.xyz[i - 3];
}

}  // namespace

int pixels_across(const SparkleCamera& camera) {
    return static_cast<int>(std::lround(camera.field_mm * 1e3 / camera.pixel_um));
}

void check(const SparkleCamera& camera) {
    require_in_range(camera.pixel_um, 1, 1000, "pixel in um");
    require_in_range(camera.field_mm * 1e3 / camera.pixel_um, kPixelsAcross.lo, kPixelsAcross.hi,
                     "field of the camera in pixels");
    const double pictures =
        static_cast<double>(camera.lamps_deg.size()) + (camera.diffuse_samples > 0 ? 2 : 0);
    require_in_range(std::pow(camera.field_mm * 1e3 / camera.pixel_um, 2) * pictures, 0,
                     kMaxTotalPixels, "pixels in all pictures");
    // The pictures, and what reading one of them takes.
    require_memory(std::pow(camera.field_mm * 1e3 / camera.pixel_um, 2) * (12 * pictures + 64),
                   fmt::format("taking and reading {} pictures of {} pixels a side", pictures,
                               pixels_across(camera)),
                   "choose a smaller field, larger pixels or fewer lamps");
    require_in_range(camera.lamp_half_angle_deg, 0, 3, "half-angle of the lamps in deg");
    require_in_range(static_cast<double>(camera.lamps_deg.size()), 0, SparkleCamera::kMaxLamps,
                     "number of lamps");
    for (double lamp : camera.lamps_deg) {
        require_in_range(lamp, SparkleCamera::kLampRange, "angle of a lamp in deg");
    }
    require_in_range(camera.diffuse_samples, 0, 65536, "directions of diffuse light");
    if (camera.diffuse_samples % 2 != 0) {
        throw DomainError(
            fmt::format("directions of diffuse light = {}: must be even", camera.diffuse_samples));
    }
}

PanelPictures take_pictures(const bsdf::Bsdf& surface, const SparkleCamera& camera,
                            const Progress& progress) {
    check(camera);
    if (surface.surface_coordinates() == bsdf::SurfaceCoordinates::unit_square) {
        require_in_range(camera.unit_square_mm, camera.field_mm, 1e5,
                         "side of the panel in mm (at least the camera's field)");
    }
    const Photographer photographer(surface, camera);
    PanelPictures pictures;
    pictures.flakes_resolved = photographer.exact();
    pictures.by_lamp.assign(camera.lamps_deg.size(), photographer.blank());
    if (camera.diffuse_samples > 0) pictures.diffuse.assign(2, photographer.blank());
    const int rows = photographer.across();
    SharedProgress counter(progress, rows);
    if (!surface.varies_over_surface() && !surface.coat_waves()) {
        Photographer::Workspace workspace(photographer);
        photographer.expose(0, workspace, pictures, counter);
        for (PanelPicture& picture : pictures.by_lamp) spread_first(picture);
        if (!pictures.diffuse.empty()) pictures.diffuse[1] = pictures.diffuse[0];
        for (PanelPicture& picture : pictures.diffuse) spread_first(picture);
        return pictures;
    }
    for (int first = 0; first < rows; first += kRowsAtOnce) {
        const int last = std::min(rows, first + kRowsAtOnce);
        parallel_for_ranges(static_cast<std::size_t>(first) * rows,
                            static_cast<std::size_t>(last) * rows, 128,
                            [&](std::size_t begin, std::size_t end) {
                                Photographer::Workspace workspace(photographer);
                                for (std::size_t p = begin; p < end; ++p)
                                    photographer.expose(p, workspace, pictures, counter);
                            });
        counter.add(last - first);
        if (counter.stopped()) throw Stopped(fmt::format("{} was stopped", kTaking));
    }
    return pictures;
}

}  // namespace nacre::measure
