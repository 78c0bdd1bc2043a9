#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "nacre/core/error.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/render.h"

// Surfaces that vary: over which piece of them each sample of a picture averages.

namespace nacre::render {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Adds up the areas of the patches that it is sampled on, in fractions of the unit square or in
/// mm^2.
class Recorder final : public bsdf::Bsdf {
    class Bound final : public bsdf::BoundBsdf {
     public:
        explicit Bound(const Recorder& owner) : owner_(owner) {}
        FloatLanes eval(Vec3f, Vec3f wo) const override {
            ++owner_.means;
            return splat(wo.z > 0 ? 0.1f : 0.0f);
        }
        std::optional<bsdf::BsdfSample> sample(Vec3f wi, float, Vec2f) const override {
            ++owner_.means;
            return mirrored(wi);
        }
        std::optional<bsdf::BsdfSample> sample_on(const bsdf::Patch& patch, Vec3f wi, float,
                                                  Vec2f) const override {
            ++owner_.patches;
            if (wi.z < owner_.min_cosine) return mirrored(wi);
            const Vec3f* edges = patch.footprint.edge_mm;
            owner_.area += owner_.coordinates_ == bsdf::SurfaceCoordinates::unit_square
                               ? std::abs(double{patch.edge_1.x} * patch.edge_2.y -
                                          double{patch.edge_1.y} * patch.edge_2.x)
                               : length(cross(edges[0], edges[1]));
            return mirrored(wi);
        }
        float pdf(Vec3f, Vec3f) const override { return 1; }
        FloatLanes albedo(Vec3f) const override { return splat(1.0f); }

     private:
        bsdf::BsdfSample mirrored(Vec3f wi) const {
            return {{-wi.x, -wi.y, wi.z}, splat(1.0f), 1, owner_.kind_};
        }
        const Recorder& owner_;
    };

 public:
    explicit Recorder(bsdf::SampleKind kind = bsdf::SampleKind::density,
                      bsdf::SurfaceCoordinates coordinates = bsdf::SurfaceCoordinates::unit_square)
        : kind_(kind), coordinates_(coordinates) {}
    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths&) const override {
        return std::make_unique<Bound>(*this);
    }
    bsdf::SurfaceCoordinates surface_coordinates() const override { return coordinates_; }

    float min_cosine = 0;  ///< patches that are seen more edge on are not added to `area`
    mutable std::atomic<double> area = 0;
    mutable std::atomic<long> patches = 0, means = 0;

 private:
    bsdf::SampleKind kind_;
    bsdf::SurfaceCoordinates coordinates_;
};

SceneDescription seen_at_45_deg(Geometry geometry) {
    SceneDescription scene;
    scene.materials["paint"] = PaintMaterial{};
    scene.shapes.push_back({std::move(geometry), "paint", {}});
    scene.camera = {.position_mm = {0, -700, 700}, .vertical_fov_deg = 20};
    return scene;
}

constexpr RenderOptions kFootprintOptions{
    .width = 96, .height = 96, .samples_per_pixel = 16, .footprint_pixels = 0.25};

TEST(Footprint, AreasOfSamplesAddUpToTheSurface) {
    // The whole panel once: the footprint of each sample is its part of its pixel. Only the samples
    // at the outline are random, some 1000 of 30 000.
    const auto recorder = std::make_shared<Recorder>();
    const Scene scene(seen_at_45_deg(FlatPanel{.width_mm = 200, .height_mm = 150}),
                      {{"paint", recorder}});
    RenderOptions options = kFootprintOptions;
    options.footprint_pixels = 0.25;
    render(scene, options);
    EXPECT_GT(recorder->patches, 10000);
    EXPECT_NEAR(recorder->area, 1, 0.01);

    // By default they cover the filter of their pixel, which reaches into others.
    recorder->area = 0;
    options.footprint_pixels = 0;
    render(scene, options);
    EXPECT_NEAR(recorder->area, 2.25, 0.0225);

    // Footprints of whole pixels overlap sixteen times.
    recorder->area = 0;
    options.footprint_pixels = 1;
    render(scene, options);
    EXPECT_NEAR(recorder->area, 16, 0.16);
}

TEST(Footprint, InObjectSpaceIsAsLargeAsTheScaledShape) {
    SceneDescription scene = seen_at_45_deg(FlatPanel{.width_mm = 100, .height_mm = 75});
    scene.shapes[0].transform = {.scale = 2, .rotation_deg = {0, 0, 25}};
    const auto recorder = std::make_shared<Recorder>(bsdf::SampleKind::density,
                                                     bsdf::SurfaceCoordinates::object_space);
    render(Scene(scene, {{"paint", recorder}}), kFootprintOptions);
    EXPECT_NEAR(recorder->area / (200 * 150), 1, 0.01);
}

TEST(Footprint, HalfASphereIsSeen) {
    // From afar the visible half. Its outline is seen edge on, where few samples cover a large area, as
    // each covers 1 / cos: what is seen at cosines below 0.1 is left out.
    SceneDescription description = seen_at_45_deg(Sphere{.radius_mm = 100});
    description.camera.position_mm = {0, -7000, 7000};
    description.camera.vertical_fov_deg = 1.4;
    const auto recorder = std::make_shared<Recorder>();
    recorder->min_cosine = 0.1f;
    render(Scene(description, {{"paint", recorder}}),
           {.width = 400, .height = 400, .samples_per_pixel = 16, .footprint_pixels = 0.25});
    // Normals up to acos(0.11) from the camera's axis, at 99 radii, are seen at such cosines.
    EXPECT_NEAR(recorder->area, 0.445, 0.001);
}

/// A panel of "paint" that the camera sees only by its reflection in a panel of "below", which is
/// large enough that a mirror would show all of it.
SceneDescription seen_by_reflection() {
    SceneDescription scene;
    scene.materials = {{"below", PaintMaterial{}}, {"paint", PaintMaterial{}}};
    scene.shapes.push_back({FlatPanel{.width_mm = 800, .height_mm = 800}, "below", {}});
    scene.shapes.push_back({FlatPanel{.width_mm = 100, .height_mm = 100},
                            "paint",
                            {.rotation_deg = {180, 0, 0}, .translation_mm = {0, 0, 300}}});
    scene.camera = {
        .position_mm = {0, -900, 600}, .target_mm = {0, 0, -300}, .vertical_fov_deg = 12};
    return scene;
}

TEST(Footprint, IsFollowedThroughSpecularReflection) {
    const auto mirror = std::make_shared<Recorder>(bsdf::SampleKind::specular),
               paint = std::make_shared<Recorder>();
    render(Scene(seen_by_reflection(), {{"below", mirror}, {"paint", paint}}), kFootprintOptions);
    EXPECT_GT(paint->patches, 5000);
    EXPECT_EQ(paint->means, 0);
    EXPECT_NEAR(paint->area, 1, 0.02);
}

TEST(Footprint, AfterARoughReflectionTheMeanIsTaken) {
    // The inside of a hollow body: two panels face to face, neither specular.
    SceneDescription scene = seen_at_45_deg(FlatPanel{.width_mm = 200, .height_mm = 150});
    scene.shapes.push_back({FlatPanel{.width_mm = 2000, .height_mm = 2000},
                            "paint",
                            {.rotation_deg = {180, 0, 0}, .translation_mm = {0, 600, 800}}});
    const auto recorder = std::make_shared<Recorder>();
    render(Scene(scene, {{"paint", recorder}}), kFootprintOptions);
    EXPECT_GT(recorder->patches, 10000);
    EXPECT_GT(recorder->means, 5000);
}

TEST(Footprint, AfterALightPathThroughAPaintTheMeanIsTaken) {
    // The reference walks do not know the density of the directions in which light leaves, which is
    // not specular for that. Without a step of the index at the surface, all light that returns
    // comes from the white substrate.
    const auto diffuse = std::make_shared<montecarlo::PlaneWalk>(
        montecarlo::test::paint_of(1.0, {montecarlo::test::pigment_layer(0.5, 0.1, 0)}, 0.9));
    const auto paint = std::make_shared<Recorder>();
    render(Scene(seen_by_reflection(), {{"below", diffuse}, {"paint", paint}}), kFootprintOptions);
    EXPECT_EQ(paint->patches, 0);
    EXPECT_GT(paint->means, 500);
}

TEST(Footprint, IsFollowedThroughTheGlossOfAPaintThatIsWalkedThrough) {
    // A black paint under a smooth surface: all that it reflects is specular.
    const auto glossy = std::make_shared<montecarlo::PlaneWalk>(
        montecarlo::test::paint_of(1.5, {montecarlo::test::pigment_layer(0, 10, 0)}));
    const auto paint = std::make_shared<Recorder>();
    render(Scene(seen_by_reflection(), {{"below", glossy}, {"paint", paint}}), kFootprintOptions);
    EXPECT_GT(paint->patches, 500);
    EXPECT_EQ(paint->means, 0);
}

TEST(Footprint, MeshesNeedTextureCoordinatesToBeLaidOut) {
    const nacre::test::TempFolder folder;
    const auto bare = folder.write("bare.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nf 1 2 3\n");
    const auto mapped = folder.write(
        "mapped.obj",
        "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nvt 0 0\nvt 0.5 0\nvt 0.5 0.5\nf 1/1 2/2 3/3\n");
    const auto recorder = std::make_shared<Recorder>();
    EXPECT_THAT(
        message_of<InputError>([&] {
            const Scene scene(seen_at_45_deg(MeshFile{.path = bare}), {{"paint", recorder}});
        }),
        AllOf(HasSubstr(bare.string()), HasSubstr("texture coordinates")));
    render(Scene(seen_at_45_deg(MeshFile{.path = mapped}), {{"paint", recorder}}),
           kFootprintOptions);
    EXPECT_NEAR(recorder->area, 0.125, 0.005);  // the triangle's fraction of the square

    const auto in_object_space = std::make_shared<Recorder>(bsdf::SampleKind::density,
                                                            bsdf::SurfaceCoordinates::object_space);
    render(Scene(seen_at_45_deg(MeshFile{.path = bare}), {{"paint", in_object_space}}),
           kFootprintOptions);
    EXPECT_NEAR(in_object_space->area / 5000, 1,
                0.04);  // half of 100 mm x 100 mm, in 10 pixels' outline
}

}  // namespace
}  // namespace nacre::render
