// From a slider's move to the numbers of the live picture (docs/live-picture.md).
//
//   ./dev bench --benchmark_filter=Live

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <variant>

#include "nacre/core/file.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/film_cache.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre {
namespace {

/// A paint whose first layer, or the first film of whose first flakes, a slider makes thicker.
class Slider {
 public:
    Slider(const char* paint, bool film)
        : film_(film),
          recipe_(io::read_recipe(shipped_file(std::string("paints/") + paint + ".toml"))) {}

    std::shared_ptr<const solver::SolvedPaint> move() {
        paint::Layer& layer = recipe_.layers[0];
        if (film_) {
            std::get<optics::Platelet>(layer.flakes[0].body).coats[0].thickness_nm *= 1.001;
        } else {
            layer.thickness_um *= 1.001;
        }
        return std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe_, spectra::default_wavelengths_nm(), {}, &films_));
    }

 private:
    bool film_;
    paint::Recipe recipe_;
    solver::FilmCache films_;
};

void BM_LiveSolve(benchmark::State& state, const char* paint) {
    Slider slider(paint, false);
    slider.move();
    for (auto _ : state) benchmark::DoNotOptimize(slider.move());
}

/// What is made of the solved paint after each move.
template <class Make>
void made(benchmark::State& state, Slider slider, const Make& make) {
    make(slider.move());
    for (auto _ : state) {
        state.PauseTiming();
        const auto solved = slider.move();
        state.ResumeTiming();
        benchmark::DoNotOptimize(make(solved));
    }
}

void BM_LiveShader(benchmark::State& state, const char* paint) {
    made(state, Slider(paint, false),
         [](const auto& solved) { return exchange::make_live_webgl_shader(solved); });
}
/// Of another film after each.
void BM_LiveFilms(benchmark::State& state, const char* paint) {
    made(state, Slider(paint, true),
         [](const auto& solved) { return exchange::make_live_webgl_films(*solved); });
}

#define NACRE_LIVE(name, paint)                   \
    BENCHMARK_CAPTURE(BM_LiveSolve, name, paint)  \
        ->Unit(benchmark::kMillisecond)           \
        ->MeasureProcessCPUTime()                 \
        ->UseRealTime();                          \
    BENCHMARK_CAPTURE(BM_LiveShader, name, paint) \
        ->Unit(benchmark::kMillisecond)           \
        ->MeasureProcessCPUTime()                 \
        ->UseRealTime();                          \
    BENCHMARK_CAPTURE(BM_LiveFilms, name, paint)  \
        ->Unit(benchmark::kMillisecond)           \
        ->MeasureProcessCPUTime()                 \
        ->UseRealTime()
NACRE_LIVE(red_gold, "red-gold");
NACRE_LIVE(ruby, "ruby");
NACRE_LIVE(satin_silver, "satin-silver");

}  // namespace
}  // namespace nacre
