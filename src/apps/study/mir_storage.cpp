#include "apps/study/mir_storage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/study/mir_2022.h"
#include "apps/study/query_cost.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/tabulated/fourier_table.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/estimate.h"
#include "nacre/core/file.h"
#include "nacre/core/math.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::study {
namespace {

constexpr bsdf::Wavelengths kWavelengthsOfTables_nm = {418, 456, 493, 531, 568, 606, 643, 681};

Vec3f direction_of(double theta_deg, double phi_deg) {
    const double s = std::sin(theta_deg * kDegree);
    return {static_cast<float>(s * std::cos(phi_deg * kDegree)),
            static_cast<float>(s * std::sin(phi_deg * kDegree)),
            static_cast<float>(std::cos(theta_deg * kDegree))};
}

}  // namespace

constinit const bsdf::ModelInfo FourierTableModel::info = {
    .name = "microflake as Fourier coefficients",
    .summary = "a table of Fourier coefficients, the flakes' reflectance applied while rendering",
    .source = "Mir et al. 2022",
    .ingredients = bsdf::Ingredients::layers,
    .solution = bsdf::Solution::solved,
    .can = {.goniochromism = true, .multiple_scattering = true},
    .standard = bsdf::standard_model<FourierTableModel>};

std::shared_ptr<const bsdf::Bsdf> FourierTableModel::make(const bsdf::ModelInput& input,
                                                          const Progress& progress) const {
    bsdf::FourierBrdfTable table = bsdf::make_fourier_table(*input.solved, table_size, progress);
    if (rank > 0) table = bsdf::compress(table, {.rank = rank});
    return std::make_shared<const bsdf::Tabulated>(
        std::make_shared<const bsdf::FourierBrdfTable>(std::move(table)));
}

std::string FourierTableModel::text() const {
    return fmt::format("fourier angles={} azimuths={} rank={}", table_size.angles,
                       table_size.azimuths, rank);
}

TableError table_error(const bsdf::Bsdf& surface, const solver::SolvedPaint& paint) {
    const auto bound = surface.bind(kWavelengthsOfTables_nm);
    const std::vector<Vec3d> weights = spectra::rec709_weights(paint.wavelengths_nm());
    const auto& basis = spectra::linear_rec709_basis();
    TableError out;
    double squares = 0;
    int count = 0;
    for (const double theta_i : {5.0, 20.0, 33.0, 45.0, 60.0, 75.0}) {
        double peak = 0, worst = 0, sum = 0;
        int here = 0;
        for (const double phi : {180.0, 176.3, 165.5, 130.0, 1.0}) {
            for (double theta_o = 0.5; theta_o < 85; theta_o += 1.7, ++here) {
                Vec3d rgb{};
                const auto f = paint.brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree);
                for (std::size_t w = 0; w < f.size(); ++w) rgb += f[w] * weights[w];
                const FloatLanes found =
                    bound->eval(direction_of(theta_i, 0), direction_of(theta_o, phi));
                for (int lane = 0; lane < kLanes; ++lane) {
                    // As the model does: a spectrum of that colour, cut off at zero.
                    double expected = 0;
                    for (int c = 0; c < 3; ++c) {
                        expected += rgb[c] * basis[c](kWavelengthsOfTables_nm[lane]);
                    }
                    expected = std::max(0.0, expected);
                    peak = std::max(peak, expected);
                    worst = std::max(worst, std::abs(found[lane] - expected));
                    sum += (found[lane] - expected) * (found[lane] - expected) / kLanes;
                }
            }
        }
        if (!(peak > 0)) continue;
        out.worst = std::max(out.worst, worst / peak);
        squares += sum / (peak * peak);
        count += here;
    }
    out.rms = count > 0 ? std::sqrt(squares / count) : 0;
    return out;
}

void add_storage(MirContext& context) {
    const bool quick = context.settings.quick;
    const bsdf::BrdfTableSettings size =
        quick ? bsdf::BrdfTableSettings{32, 32} : bsdf::BrdfTableSettings{};
    const int queries = quick ? 256 : 4096, rounds = quick ? 3 : 9;
    struct Subject {
        const char* name;
        const char* file;
    };
    report::Table table{
        .caption = "Two ways to store a table",
        .columns = {"paint", "stored", "data", "worst error", "rms error", "value, ns"}};
    context.gallery.stage()("ways to store a table", [&](const Progress& progress) {
        for (const Subject& subject : {Subject{"metallic gray", "paints/metallic-gray.toml"},
                                       {"cadmium red", "paints/cadmium-red.toml"},
                                       {"80 nm of TiO₂", "paints/tio2-mica-80.toml"}}) {
            const solver::SolvedPaint paint =
                solver::solve(io::read_recipe(shipped_file(subject.file)),
                              spectra::default_wavelengths_nm(), {}, nullptr, progress);
            bool first = true;
            const auto add = [&](const char* key, const char* name, std::size_t bytes,
                                 const bsdf::Bsdf& surface) {
                const TableError error = table_error(surface, paint);
                const QuerySubject asked(surface, queries);
                std::vector<double> times;
                for (int n = 0; n < rounds; ++n) {
                    times.push_back(asked.measure({}, QueryKind::value).nanoseconds);
                }
                const double value_ns = median(times);
                table.rows.push_back({{first ? subject.name : ""},
                                      {name},
                                      report::number_cell(mebibytes(bytes)),
                                      report::number_cell(fmt::format("{:.1e}", error.worst)),
                                      report::number_cell(fmt::format("{:.1e}", error.rms)),
                                      report::number_cell(fmt::format("{:.0f}", value_ns))});
                first = false;
                context.results["storage"][subject.name][key] = {{"bytes", bytes},
                                                                 {"worst_error", error.worst},
                                                                 {"rms_error", error.rms},
                                                                 {"value_ns", value_ns}};
            };
            const auto add_table = [&](const char* key, const char* name, auto data) {
                const std::size_t bytes = data.bytes();
                using T = decltype(data);
                add(key, name, bytes, bsdf::Tabulated(std::make_shared<const T>(std::move(data))));
            };
            const bsdf::FourierBrdfTable fourier = bsdf::make_fourier_table(paint, size, progress);
            const bsdf::RawBrdfTable raw = bsdf::make_raw_table(paint, size, progress);
            add_table("fourier", "paper's: Fourier coefficients, R applied", fourier);
            add_table("warped", "ours: values, azimuths along the lobe", raw);
            add_table("fourier-3", "paper's, r = 3", bsdf::compress(fourier, {.rank = 3}));
            add_table("warped-3", "ours, r = 3", bsdf::compress(raw, {.rank = 3}));
            add_table("fourier-4", "paper's, r = 4", bsdf::compress(fourier, {.rank = 4}));
            add_table("warped-4", "ours, r = 4", bsdf::compress(raw, {.rank = 4}));
        }
    });
    context.report.heading(2, "The paper's way to store a table, and ours", "storage");
    context.report.paragraph(
        "The paper stores Fourier coefficients in azimuth of what remains when the flakes' "
        "reflectance R is taken out, and applies R while rendering. So does the first of these, "
        "for the whole solved BRDF; where R is next to nothing in a channel (the green of the "
        "red), it is not taken out. Ours, of Table 1, are values at azimuths that follow the half "
        "vector. As many numbers each. Errors are against the colour of the solved BRDF between "
        "the nodes, over the peak of each incident direction. Where both err alike, it is by the "
        "linear interpolation between polar angles. A look-up of coefficients sums a series.");
    context.table("storage", table);
}

}  // namespace nacre::study
