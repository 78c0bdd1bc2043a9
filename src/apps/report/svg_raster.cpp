#include "apps/report/svg_raster.h"

#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "nacre/core/error.h"

namespace nacre::report {

namespace {

struct Release {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(GError* error) const { g_error_free(error); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

/// The message of an error that a C function handed out, which is freed.
std::string message_of(GError* error) {
    const Owned<GError> owned(error);
    return owned ? owned->message : "no reason was given";
}

Owned<RsvgHandle> parse(std::string_view svg) {
    GError* error = nullptr;
    Owned<RsvgHandle> handle(
        rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) throw DomainError("the text is no SVG: " + message_of(error));
    return handle;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

void require_success(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error(fmt::format("a picture cannot be drawn: {}", cairo_status_to_string(status)));
}

}  // namespace

std::string png_of_svg(std::string_view svg, double scale) {
    require_in_range(scale, 0.01, 100, "scale of a picture");
    const Owned<RsvgHandle> handle = parse(svg);
    double width_px = 0, height_px = 0;
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width_px, &height_px)) {
        throw DomainError("the SVG does not say its size in px");
    }
    const double width = std::round(width_px * scale), height = std::round(height_px * scale);
    if (!(width >= 1 && height >= 1 && width * height <= kMaxRasterPixels)) {
        throw DomainError(fmt::format("a picture of {} x {} pixels: must have 1 to {}", width,
                                      height, kMaxRasterPixels));
    }
    const Owned<cairo_surface_t> surface(cairo_image_surface_create(
        CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height)));
    require_success(cairo_surface_status(surface.get()));
    {
        const Owned<cairo_t> context(cairo_create(surface.get()));
        const RsvgRectangle whole{0, 0, width, height};
        GError* error = nullptr;
        if (!rsvg_handle_render_document(handle.get(), context.get(), &whole, &error)) {
            throw Error("a picture cannot be drawn: " + message_of(error));
        }
        require_success(cairo_status(context.get()));
    }
    std::string png;
    require_success(cairo_surface_write_to_png_stream(surface.get(), append, &png));
    return png;
}

}  // namespace nacre::report
