#include "nacre/render.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstring>
#include <tuple>

#include "arrays.h"
#include "bind.h"
#include "image_arrays.h"
#include "nacre/models/traced/traced_models.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/shard_file.h"
#include "nacre/render/turntable.h"
#include "paint_handle.h"
#include "work.h"

// The extension nacre._render: pictures, which need Embree and assimp. It shares the classes of
// nacre._nacre, which must be imported first, and makes models of its own: only it knows those that
// trace rays among flakes.

namespace nacre::python {

namespace {

using namespace nb::literals;

/// A model, or the one that shows its paint in another way: {"flakes": "explicit"}.
Model render_model(const std::string& name, ModelChoices options) {
    for (const bsdf::ModelInfo* traced : models::traced_models()) {
        const bsdf::Alternative& alternative = *traced->alternative;
        if (alternative.to->name != name) continue;
        const std::string key(alternative.flag.substr(2));
        const auto given = options.find(key);
        if (given == options.end()) continue;
        const std::string value = given->second;
        options.erase(given);
        const Model model = configured_model(name, options);
        if (value == alternative.value) return alternative.from(model);
        if (value != alternative.usual) {
            throw SettingError(key,
                               "must be one of " + std::string(alternative.usual) + ", " +
                                   std::string(alternative.value),
                               value);
        }
        return model;
    }
    return configured_model(name, options);
}

using FloatView = nb::ndarray<nb::numpy, const float>;

/// A picture's memory as numpy sees it: it keeps the picture alive. None where it is empty.
nb::object view(nb::handle owner, const Picture& picture, const std::vector<float>& values,
                std::size_t depth) {
    if (values.empty()) return nb::none();
    Shape shape = {static_cast<std::size_t>(picture.result.height),
                   static_cast<std::size_t>(picture.result.width)};
    if (depth > 0) shape.push_back(depth);
    return nb::cast(FloatView(values.data(), shape.size(), shape.data(), owner));
}

/// A property with `depth` values a pixel; 0: one, without an axis of its own.
auto pixels(std::vector<float> render::RenderResult::*member, std::size_t depth) {
    return [member, depth](nb::handle self) {
        const Picture& picture = nb::cast<const Picture&>(self);
        return view(self, picture, picture.result.*member, depth);
    };
}

nb::object spectral(nb::handle self) {
    const Picture& picture = nb::cast<const Picture&>(self);
    return view(self, picture, picture.result.spectral, picture.result.bin_centres_nm.size());
}

nb::tuple image(const Picture& picture) { return to_arrays(picture.image()); }

/// Of a picture: another place of what turns, and a shard of the samples.
struct PictureParts {
    std::optional<std::pair<std::string, double>> turntable;
    std::optional<std::pair<int, int>> shard;
    std::optional<std::filesystem::path> resume;  ///< that may hold it
};

/// The picture of a shard's samples, and what nacre.merge() takes of it.
struct ShardPicture : Picture {
    PictureShard shard;

    explicit ShardPicture(PictureShard s)
        : Picture{render::develop(s.sums, s.options), render::picture_metadata(s)},
          shard(std::move(s)) {
        result.complete = shard.shard.count == 1;
    }
};

nb::bytes bytes_of(const std::vector<float>& values) {
    return nb::bytes(values.data(), values.size() * sizeof(float));
}

std::vector<float> floats_of(const nb::bytes& bytes) {
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
}

using PictureState =
    std::tuple<std::pair<int, int>, std::array<nb::bytes, 6>, std::vector<double>, int,
               std::optional<double>, long, double, bool, std::map<std::string, std::string>>;

/// For pickling: every number, bit for bit.
PictureState state_of(const Picture& p) {
    const render::RenderResult& r = p.result;
    return {{r.width, r.height},
            {bytes_of(r.rgb), bytes_of(r.albedo), bytes_of(r.normal), bytes_of(r.alpha),
             bytes_of(r.sparkle), bytes_of(r.spectral)},
            r.bin_centres_nm,
            r.samples,
            r.noise,
            r.invalid_paths,
            r.seconds,
            r.complete,
            p.metadata};
}

Picture from_state(const PictureState& state) {
    const auto& [size, pixels, bins, samples, noise, invalid, seconds, complete, metadata] = state;
    Picture p;
    render::RenderResult& r = p.result;
    std::tie(r.width, r.height) = size;
    std::vector<float>* const channels[] = {&r.rgb,   &r.albedo,  &r.normal,
                                            &r.alpha, &r.sparkle, &r.spectral};
    const std::size_t depths[] = {3, 3, 3, 1, 3, bins.size()};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        *channels[i] = floats_of(pixels[i]);
        // Or numpy would read beyond them.
        const std::size_t whole = count(
            {static_cast<std::size_t>(r.width), static_cast<std::size_t>(r.height), depths[i]});
        if (!channels[i]->empty() && channels[i]->size() != whole) {
            throw InputError("pickle: pixels that do not fit the size of their picture");
        }
    }
    r.bin_centres_nm = bins;
    r.samples = samples;
    r.noise = noise;
    r.invalid_paths = invalid;
    r.seconds = seconds;
    r.complete = complete;
    p.metadata = metadata;
    return p;
}

void write_shard_picture(const ShardPicture& picture, const std::filesystem::path& path,
                         double exposure_stops) {
    if (path.extension() == ".h5") return write_shard(path, picture.shard);
    picture.write(path, {exposure_stops});
}

Shard shard_of(std::pair<int, int> number_and_count) {
    return {number_and_count.first, number_and_count.second};
}

nb::object render(const std::filesystem::path& scene_name, const std::optional<PaintHandle>& paint,
                  const std::optional<std::pair<std::string, ModelChoices>>& model,
                  const RenderSettings& settings, const PictureParts& parts,
                  const nb::object& progress) {
    const auto scene = [&](const Progress& callback) {
        render::check(settings, parts.shard ? shard_of(*parts.shard)
                                            : Shard{});  // before the paint is solved
        ScenePaints paints;
        if (paint) paints.slot = paint->paint;
        if (model) paints.model = render_model(model->first, model->second);
        render::SceneDescription description = find_scene(scene_name.string());
        if (parts.turntable) {
            description = render::turned(std::move(description),
                                         render::turning_called(parts.turntable->first),
                                         parts.turntable->second);
        }
        return Scene(std::move(description), paints, [&](double) { return callback(0); });
    };
    if (!parts.shard) {
        return nb::cast(run(progress, [&](const Progress& callback) {
            return scene(callback).render(settings, callback);
        }));
    }
    return nb::cast(run(progress, [&](const Progress& callback) {
        const Scene shown = scene(callback);
        const Shard shard = shard_of(*parts.shard);
        std::optional<PictureShard> found;
        if (parts.resume) found = shown.find_shard(*parts.resume, settings, shard);
        return ShardPicture(found ? std::move(*found)
                                  : shown.render_shard(settings, shard, callback));
    }));
}

}  // namespace

}  // namespace nacre::python

NB_MODULE(_render, module) {
    using namespace nacre::python;
    using namespace nanobind::literals;
    nanobind::module_::import_("nacre._nacre");
    translate_errors();
    using nacre::Picture;
    using nacre::render::RenderResult;
    nanobind::class_<Picture>(module, "Picture")
        .def_prop_ro("rgb", pixels(&RenderResult::rgb, 3))
        .def_prop_ro("albedo", pixels(&RenderResult::albedo, 3))
        .def_prop_ro("normal", pixels(&RenderResult::normal, 3))
        .def_prop_ro("alpha", pixels(&RenderResult::alpha, 0))
        .def_prop_ro("sparkle", pixels(&RenderResult::sparkle, 3))
        .def_prop_ro("spectral", &spectral)
        .def_prop_ro(
            "bin_centres_nm",
            [](const Picture& p) { return to_numpy(std::vector<double>(p.result.bin_centres_nm)); },
            kOwned)
        .def_prop_ro("noise", [](const Picture& p) { return p.result.noise; })
        .def_prop_ro("samples", [](const Picture& p) { return p.result.samples; })
        .def_prop_ro("complete", [](const Picture& p) { return p.result.complete; })
        .def_prop_ro("seconds", [](const Picture& p) { return p.result.seconds; })
        .def_prop_ro("shard",
                     [](const Picture&) -> std::optional<std::pair<int, int>> { return {}; })
        .def("__getstate__", &state_of, kGetStateSignature)
        .def(
            "__setstate__",
            [](Picture& p, const PictureState& state) { new (&p) Picture(from_state(state)); },
            kSetStateSignature)
        .def("image", &image)
        .def(
            "write",
            [](const Picture& p, const std::filesystem::path& path, double exposure_stops) {
                p.write(path, {exposure_stops});
            },
            "path"_a, "exposure_stops"_a, nanobind::call_guard<nanobind::gil_scoped_release>())
        .def(
            "write_exr_and_png",
            [](const Picture& p, const std::filesystem::path& exr, double exposure_stops) {
                nacre::io::write_exr_and_png(exr, p.image(), {exposure_stops});
            },
            "exr"_a, "exposure_stops"_a, nanobind::call_guard<nanobind::gil_scoped_release>());
    nanobind::class_<ShardPicture, Picture>(module, "ShardPicture")
        .def_prop_ro("shard",
                     [](const ShardPicture& p) {
                         return std::pair(p.shard.shard.number, p.shard.shard.count);
                     })
        .def(
            "__getstate__",
            [](const ShardPicture& p) {
                const std::string bytes = nacre::render::shard_bytes(p.shard);
                return nanobind::bytes(bytes.data(), bytes.size());
            },
            kGetStateSignature)
        .def(
            "__setstate__",
            [](ShardPicture& p, const nanobind::bytes& bytes) {
                new (&p) ShardPicture(
                    nacre::render::parse_shard({bytes.c_str(), bytes.size()}, "pickle"));
            },
            kSetStateSignature)
        .def("write", &write_shard_picture, "path"_a, "exposure_stops"_a,
             nanobind::call_guard<nanobind::gil_scoped_release>());
    module.def(
        "merge",
        [](const std::vector<std::filesystem::path>& shards) {
            return nacre::merge_shards(shards);
        },
        "shards"_a, nanobind::call_guard<nanobind::gil_scoped_release>());
    module.def(
        "render",
        [](const std::filesystem::path& scene, const std::optional<PaintHandle>& paint,
           const std::optional<std::pair<std::string, ModelChoices>>& model, int width, int height,
           int spp, std::uint64_t seed, int depth, double footprint_pixels, bool sparkle,
           bool noise, int spectral_bins,
           const std::optional<std::pair<std::string, double>>& turntable,
           const std::optional<std::pair<int, int>>& shard,
           const std::optional<std::filesystem::path>& resume, const nanobind::object& progress) {
            return render(scene, paint, model,
                          {.width = width,
                           .height = height,
                           .samples_per_pixel = spp,
                           .seed = seed,
                           .max_depth = depth,
                           .footprint_pixels = footprint_pixels,
                           .sparkle = sparkle,
                           .noise = noise,
                           .spectral_bins = spectral_bins},
                          {turntable, shard, resume}, progress);
        },
        "scene"_a, "paint"_a.none(), "model"_a.none(), "width"_a, "height"_a, "spp"_a, "seed"_a,
        "depth"_a, "footprint_pixels"_a, "sparkle"_a, "noise"_a, "spectral_bins"_a,
        "turntable"_a.none(), "shard"_a.none(), "resume"_a.none(), "progress"_a.none());
    module.def("scene_names", &nacre::render::builtin_scene_names);
}
