#include "apps/study/sparkle.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/report/report.h"
#include "apps/study/folder.h"
#include "apps/study/mir_2022.h"
#include "apps/study/sparkle_series.h"
#include "nacre/core/file.h"
#include "nacre/core/random.h"
#include "nacre/core/version.h"
#include "nacre/io/panel_image.h"
#include "nacre/io/recipe_file.h"

namespace nacre::study {
namespace {

using nlohmann::json;

struct Series {
    FlakeParameter parameter;
    const char* key;
    const char* title;
    const char* axis;
    bool logarithmic;
    std::vector<double> values;
    std::vector<double> shown;  // of which pictures are on the page
};

// What is expected, and why.
struct Expectation {
    FlakeParameter parameter;
    SparkleMeasure measure;
    int lamp;  // -1: diffuse
    Trend trend;
    const char* reason;
};

std::vector<Series> series_of(bool quick) {
    std::vector<Series> all = {{FlakeParameter::diameter,
                                "diameter",
                                "Diameter of the flakes",
                                "diameter, um",
                                true,
                                {10, 16, 25, 40, 63, 100},
                                {10, 25, 63}},
                               {FlakeParameter::volume,
                                "volume",
                                "Volume fraction of the flakes",
                                "volume fraction",
                                true,
                                {0.0006, 0.001, 0.002, 0.004, 0.01},
                                {0.0006, 0.002, 0.01}},
                               {FlakeParameter::orientation,
                                "orientation",
                                "How the flakes lie",
                                "alpha",
                                false,
                                {0.08, 0.12, 0.16, 0.22, 0.3},
                                {0.08, 0.16, 0.3}}};
    if (quick) {
        for (Series& s : all) {
            s.values = {s.values[1], s.values.back()};
            s.shown = {s.values[0]};
        }
    }
    return all;
}

constexpr Expectation kExpectations[] = {
    {FlakeParameter::diameter, SparkleMeasure::intensity, 0, Trend::rises,
     "a larger flake sends more light, into a narrower lobe (Kirchner et al. 2015)"},
    {FlakeParameter::diameter, SparkleMeasure::graininess, -1, Trend::rises,
     "fewer flakes in what the eye resolves average out less: contrast goes with the diameter"},
    {FlakeParameter::volume, SparkleMeasure::density, 0, Trend::rises,
     "more flakes, more of them at the right tilt"},
    {FlakeParameter::volume, SparkleMeasure::intensity, 0, Trend::falls,
     "the light that flakes scatter among them is the background of each (Kirchner et al. 2015)"},
    {FlakeParameter::volume, SparkleMeasure::graininess, -1, Trend::falls,
     "more flakes average out better"},
    {FlakeParameter::orientation, SparkleMeasure::density, 2, Trend::rises,
     "more flakes are tilted so far that they answer a lamp at 75°"},
};

class Study {
 public:
    Study(const SparkleStudySettings& settings, const Stage& stage)
        : settings_(settings),
          stage_(stage),
          report_("Sparkle and graininess",
                  "How they follow from the flakes, in the "
                  "model `nacre`") {
        field_mm_ = settings.quick ? 3 : 10;
        make_folder(settings.folder / "pictures");
    }

    std::filesystem::path run() {
        introduction();
        for (const Series& series : series_of(settings_.quick)) add_series(series);
        add_verdicts();
        add_paints();
        results_["study"] = "sparkle";
        results_["version"] = version();
        results_["seed"] = settings_.seed;
        results_["quick"] = settings_.quick;
        return write_page(settings_.folder, report_.html(), results_);
    }

 private:
    void introduction() {
        report_.paragraph(
            "A virtual camera looks along the normal of flat panels, under lamps at 15, 45 and 75 "
            "degrees and in diffuse light. What it sees is read as docs/sparkle.md defines: spots "
            "that the eye notices, how far they are above the threshold of seeing, and the grain, "
            "in thresholds too. These scales are not those of any commercial instrument.");
        if (settings_.quick) {
            report_.note("Quick: small panels, few points. The numbers mean little.");
        }
        const measure::Viewing viewing;
        report_.definitions(
            {{"Camera",
              fmt::format("{} mm of the panel in pixels of {} um; {:.3g} mm of large flakes",
                          field_mm_, camera_.pixel_um, 2.4 * field_mm_)},
             {"Lamps", fmt::format("evenly bright discs of {}° radius, nearly the sun's",
                                   camera_.lamp_half_angle_deg)},
             {"Eye", fmt::format("at {} mm, {} lx on the panel", viewing.distance_mm,
                                 viewing.illuminance_lx)},
             {"Paint", "metallic-silver, one number of it varied"},
             {"Errors",
              "one standard error, by the jackknife over 16 pieces of the picture; every "
              "panel has flakes of its own"},
             {"Program", fmt::format("nacre {}, seed {}", version(), settings_.seed)}});
    }

    PanelLook look(const std::string& label, const paint::Recipe& recipe) {
        PanelLook result;
        const std::uint64_t seed = hash_of(settings_.seed, ++panels_);
        stage_(label, [&](const Progress& progress) {
            result = look_at(recipe, camera_for(recipe, field_mm_), seed, progress);
        });
        return result;
    }

    std::string png(const measure::PanelPicture& picture, const std::string& key) {
        constexpr double kShown_mm = 6;  // enough to see
        const int side =
            std::min(picture.width, static_cast<int>(std::lround(kShown_mm / picture.pixel_mm)));
        measure::PanelPicture piece{side, side, picture.pixel_mm, {}};
        for (int y = 0; y < side; ++y) {
            const float* const row = &picture.xyz[static_cast<std::size_t>(3 * y) * picture.width];
            piece.xyz.insert(piece.xyz.end(), row, row + 3 * side);
        }
        const auto file = settings_.folder / "pictures" / (key + ".png");
        check_own(file);
        io::write_png(file, io::image_of(piece, {{"nacre:study", "sparkle"}}),
                      {io::display_stops(picture)});
        return read_file(file);
    }

    void add_pictures(std::vector<report::Picture>& pictures, const PanelLook& panel,
                      const std::string& key, const std::string& caption) {
        for (std::size_t lamp = 0; lamp < camera_.lamps_deg.size(); ++lamp) {
            const double angle = camera_.lamps_deg[lamp];
            pictures.push_back(
                {fmt::format("{}, {}°", caption, angle),
                 png(panel.pictures.by_lamp[lamp], fmt::format("{}-{}", key, angle))});
        }
        pictures.push_back(
            {caption + ", diffuse", png(panel.pictures.diffuse[0], key + "-diffuse")});
    }

    void add_series(const Series& series) {
        report_.heading(1, series.title, series.key);
        std::vector<measure::SparkleMeasurement> readings;
        std::vector<report::Picture> pictures;
        for (double value : series.values) {
            const PanelLook panel =
                look(fmt::format("{} {}", series.key, value), silver_with(series.parameter, value));
            readings.push_back(panel.readings);
            if (std::find(series.shown.begin(), series.shown.end(), value) != series.shown.end()) {
                add_pictures(pictures, panel, fmt::format("{}-{}", series.key, value),
                             fmt::format("{} {}", series.key, value));
            }
        }
        for (SparkleMeasure measure : {SparkleMeasure::density, SparkleMeasure::intensity,
                                       SparkleMeasure::sparkle, SparkleMeasure::graininess}) {
            report_.plot(plot_of(series, measure, readings));
        }
        report_.pictures(pictures, 4,
                         "6 mm of the panels as the camera saw them; the mean of each picture is "
                         "shown as a quarter of white.");
        for (const Expectation& e : kExpectations) {
            if (e.parameter == series.parameter) judge_series(series, e, readings);
        }
    }

    report::Plot plot_of(const Series& series, SparkleMeasure measure,
                         const std::vector<measure::SparkleMeasurement>& readings) {
        report::Plot plot;
        plot.title = name(measure);
        plot.x = {.label = series.axis, .logarithmic = series.logarithmic};
        plot.y = {.label = measure == SparkleMeasure::density     ? "spots per cm²"
                           : measure == SparkleMeasure::sparkle   ? "decades of threshold per cm²"
                           : measure == SparkleMeasure::intensity ? "decades above threshold"
                                                                  : "thresholds",
                  .logarithmic = measure != SparkleMeasure::intensity};
        const bool diffuse = measure == SparkleMeasure::graininess;
        const std::size_t lines = diffuse ? 1 : camera_.lamps_deg.size();
        for (std::size_t lamp = 0; lamp < lines; ++lamp) {
            report::Series line;
            line.name = diffuse ? "diffuse" : fmt::format("{}°", camera_.lamps_deg[lamp]);
            line.dots = true;
            for (std::size_t i = 0; i < readings.size(); ++i) {
                const Estimate r = reading(readings[i], measure, lamp);
                line.x.push_back(series.values[i]);
                line.y.push_back(r.value);
                line.y_error.push_back(r.standard_error);
                results_["series"][series.key][name(measure)][line.name].push_back(
                    {{"at", series.values[i]}, {"value", r.value}, {"error", r.standard_error}});
            }
            plot.series.push_back(std::move(line));
        }
        return plot;
    }

    void judge_series(const Series& series, const Expectation& e,
                      const std::vector<measure::SparkleMeasurement>& readings) {
        std::vector<Estimate> values;
        for (const auto& r : readings) {
            values.push_back(reading(r, e.measure, static_cast<std::size_t>(std::max(0, e.lamp))));
        }
        const TrendVerdict v = judge(values, e.trend);
        const std::string where =
            e.lamp < 0 ? "diffuse" : fmt::format("{}°", camera_.lamps_deg[e.lamp]);
        const auto with_error = [](const Estimate& m) {
            return report::number_cell(
                fmt::format("{} ± {}", number(m.value), number(m.standard_error, 2)));
        };
        verdicts_.rows.push_back(
            {{fmt::format("{}, {}", name(e.measure), where)},
             {fmt::format("{} with {}", e.trend == Trend::rises ? "rises" : "falls", series.key)},
             with_error(v.first),
             with_error(v.last),
             report::number_cell(number(v.change_in_errors)),
             report::number_cell(number(v.worst_step_in_errors)),
             {v.holds() ? "yes" : "no", false, !v.holds()}});
        reasons_.push_back(fmt::format("*{}, {}*, {} with {}: {}.", name(e.measure), where,
                                       e.trend == Trend::rises ? "rises" : "falls", series.key,
                                       e.reason));
        results_["verdicts"].push_back({{"measure", name(e.measure)},
                                        {"where", where},
                                        {"parameter", series.key},
                                        {"rises", e.trend == Trend::rises},
                                        {"change_in_errors", v.change_in_errors},
                                        {"worst_step_in_errors", v.worst_step_in_errors},
                                        {"holds", v.holds()}});
    }

    void add_verdicts() {
        report_.heading(1, "As expected?", "verdicts");
        report_.table(verdicts_);
        report_.bullets(reasons_);
        report_.paragraph(
            "A trend holds if the last panel differs from the first by four standard errors and "
            "more, and no step goes against it by three. Flakes that flash close together are "
            "blurred into a sheen by the eye: of small ones few spots stand out, and of more than "
            "the largest volume shown fewer again. Large ones are few themselves, which shows "
            "first "
            "under 75 degrees.");
    }

    void add_paints() {
        report_.heading(1, "The paints", "paints");
        report::Table table{.columns = {"paint", "spots per cm², 15°", "45°", "75°",
                                        "log10 of intensity, 15°", "45°", "75°", "graininess"}};
        std::vector<report::Picture> pictures;
        for (const char* paint :
             {"metallic-silver", "glitter-100um", "ruby", "tio2-mica-110", "tio2-mica-80",
              "white-pearl", "red-gold", "candy-red", "flip-flop", "green-violet"}) {
            const PanelLook panel =
                look(paint, io::read_recipe(shipped_file(fmt::format("paints/{}.toml", paint))));
            std::vector<report::Cell> row = {{paint}};
            for (SparkleMeasure measure :
                 {SparkleMeasure::density, SparkleMeasure::intensity, SparkleMeasure::graininess}) {
                const bool diffuse = measure == SparkleMeasure::graininess;
                for (std::size_t lamp = 0; lamp < (diffuse ? 1 : 3); ++lamp) {
                    const Estimate r = reading(panel.readings, measure, lamp);
                    row.push_back(report::number_cell(
                        std::isnan(r.value) ? "none"
                                            : fmt::format("{} ± {}", number(r.value),
                                                          number(r.standard_error, 2))));
                    results_["paints"][paint][name(measure)].push_back(
                        {{"value", r.value}, {"error", r.standard_error}});
                }
            }
            table.rows.push_back(std::move(row));
            add_pictures(pictures, panel, paint, paint);
            if (settings_.quick && table.rows.size() == 2) break;
        }
        report_.table(table);
        report_.pictures(pictures, 4);
    }

    const SparkleStudySettings& settings_;
    const Stage& stage_;
    report::Report report_;
    json results_;
    measure::SparkleCamera camera_;
    double field_mm_;
    int panels_ = 0;
    std::vector<std::string> reasons_;
    report::Table verdicts_{.columns = {"measure", "expected", "first", "last", "change, in errors",
                                        "worst step, in errors", "holds"}};
};

}  // namespace

std::filesystem::path run_sparkle(const SparkleStudySettings& settings, const Stage& stage) {
    const FolderLock lock(settings.folder);
    check_page(settings.folder);
    return Study(settings, stage).run();
}

}  // namespace nacre::study
