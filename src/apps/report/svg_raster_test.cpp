#include "apps/report/svg_raster.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>

#include "apps/report/plot_svg.h"
#include "nacre/core/error.h"

namespace nacre::report {
namespace {

/// A PNG file, read by cairo.
class Pixels {
 public:
    explicit Pixels(std::string png)
        : rest_(png), surface_(cairo_image_surface_create_from_png_stream(read, &rest_)) {}
    ~Pixels() { cairo_surface_destroy(surface_); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    int width() const { return cairo_image_surface_get_width(surface_); }
    int height() const { return cairo_image_surface_get_height(surface_); }
    std::uint32_t rgb(int x, int y) const {
        std::uint32_t argb = 0;
        std::memcpy(&argb,
                    cairo_image_surface_get_data(surface_) +
                        y * cairo_image_surface_get_stride(surface_) + 4 * x,
                    4);
        return argb & 0xFFFFFF;
    }

 private:
    static cairo_status_t read(void* from, unsigned char* to, unsigned int size) {
        auto& rest = *static_cast<std::string*>(from);
        if (rest.size() < size) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(to, rest.data(), size);
        rest.erase(0, size);
        return CAIRO_STATUS_SUCCESS;
    }

    std::string rest_;
    cairo_surface_t* surface_;
};

constexpr const char* kSquares =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"2\">"
    "<rect width=\"4\" height=\"2\" fill=\"#ffffff\"/>"
    "<rect x=\"1\" width=\"1\" height=\"2\" fill=\"#c81e32\"/></svg>";

TEST(SvgRaster, HasTheSizeAndTheColoursOfTheDrawing) {
    for (const int scale : {1, 3}) {
        const Pixels pixels(png_of_svg(kSquares, scale));
        ASSERT_EQ(pixels.width(), 4 * scale);
        ASSERT_EQ(pixels.height(), 2 * scale);
        for (int x = 0; x < pixels.width(); ++x) {
            EXPECT_EQ(pixels.rgb(x, scale), x / scale == 1 ? 0xc81e32u : 0xffffffu) << x;
        }
    }
}

TEST(SvgRaster, ShowsASeriesWhereItsPointsAre) {
    const Plot plot{.x = {.lo = 0, .hi = 10},
                    .y = {.lo = 0, .hi = 4},
                    .series = {{.x = {0, 10}, .y = {1, 1}, .colour = "#2a9d3f"},
                               {.x = {5}, .y = {3}, .point_colours = {"#7a3fd1"}, .dots = true}}};
    const Pixels pixels(png_of_svg(plot_svg(plot, {.width_px = 490, .height_px = 280}), 2));
    EXPECT_EQ(pixels.width(), 980);
    EXPECT_EQ(pixels.height(), 560);
    // As in PlotSvg.DrawsPointsAtTheirPlaces, at two pixels a px: y = 1 is at 182, (5, 3) at
    // (262, 82).
    EXPECT_EQ(pixels.rgb(300, 364), 0x2a9d3fu);
    EXPECT_EQ(pixels.rgb(524, 164), 0x7a3fd1u);
    EXPECT_EQ(pixels.rgb(2, 2), 0xffffffu);
}

TEST(SvgRaster, RefusesWhatItCannotDraw) {
    EXPECT_THROW(png_of_svg(""), DomainError);
    EXPECT_THROW(png_of_svg("no picture"), DomainError);
    EXPECT_THROW(png_of_svg("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"), DomainError);
    EXPECT_THROW(png_of_svg(kSquares, 0), DomainError);
    EXPECT_THROW(png_of_svg(kSquares, 1e9), DomainError);
    EXPECT_THROW(
        png_of_svg("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1e6\" height=\"1e6\"/>"),
        DomainError);
}

}  // namespace
}  // namespace nacre::report
