#include "apps/report/svg_raster.h"

#include <cairo.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::report {

namespace {

/// librsvg, with cairo and GObject on which it stands, from the first picture on: they come with forty
/// libraries, and a third of the time in which the program started went into loading them.
struct Librsvg {
    static constexpr const char* kLibrary = "librsvg-2.so.2";

    static void* open() {
        void* const opened = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
        if (!opened) throw Error(fmt::format("a picture cannot be drawn: {}", ::dlerror()));
        return opened;
    }
    template <class Function>
    Function* find(const char* name) const {
        void* const found = ::dlsym(library, name);
        if (!found) {
            throw Error(fmt::format("a picture cannot be drawn: {} has no {}", kLibrary, name));
        }
        return reinterpret_cast<Function*>(found);
    }

    void* library = open();
#define NACRE_FIND(name) decltype(::name)* name = find<decltype(::name)>(#name)
    NACRE_FIND(rsvg_handle_new_from_data);
    NACRE_FIND(rsvg_handle_get_intrinsic_size_in_pixels);
    NACRE_FIND(rsvg_handle_render_document);
    NACRE_FIND(g_object_unref);
    NACRE_FIND(g_error_free);
    NACRE_FIND(cairo_create);
    NACRE_FIND(cairo_destroy);
    NACRE_FIND(cairo_status);
    NACRE_FIND(cairo_status_to_string);
    NACRE_FIND(cairo_image_surface_create);
    NACRE_FIND(cairo_image_surface_get_data);
    NACRE_FIND(cairo_image_surface_get_width);
    NACRE_FIND(cairo_image_surface_get_height);
    NACRE_FIND(cairo_image_surface_get_stride);
    NACRE_FIND(cairo_surface_destroy);
    NACRE_FIND(cairo_surface_flush);
    NACRE_FIND(cairo_surface_status);
    NACRE_FIND(cairo_surface_write_to_png_stream);
#undef NACRE_FIND
};

/// @throws Error if it cannot be loaded
const Librsvg& librsvg() {
    static const Librsvg functions;
    return functions;
}

struct Release {
    void operator()(RsvgHandle* handle) const { librsvg().g_object_unref(handle); }
    void operator()(GError* error) const { librsvg().g_error_free(error); }
    void operator()(cairo_surface_t* surface) const { librsvg().cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { librsvg().cairo_destroy(context); }
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
    Owned<RsvgHandle> handle(librsvg().rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) throw DomainError("the text is no SVG: " + message_of(error));
    return handle;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

void require_success(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error(
        fmt::format("a picture cannot be drawn: {}", librsvg().cairo_status_to_string(status)));
}

/// The drawing on a surface of 32-bit pixels: `scale` of them for one px.
Owned<cairo_surface_t> draw(std::string_view svg, double scale) {
    const Owned<RsvgHandle> handle = parse(svg);
    double width_px = 0, height_px = 0;
    if (!librsvg().rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width_px, &height_px)) {
        throw DomainError("the SVG does not say its size in px");
    }
    const double width = std::round(width_px * scale), height = std::round(height_px * scale);
    if (!(width >= 1 && height >= 1 && width * height <= kMaxRasterPixels)) {
        throw DomainError(fmt::format("a picture of {} x {} pixels: must have 1 to {}", width,
                                      height, kMaxRasterPixels));
    }
    Owned<cairo_surface_t> surface(librsvg().cairo_image_surface_create(
        CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height)));
    require_success(librsvg().cairo_surface_status(surface.get()));
    const Owned<cairo_t> context(librsvg().cairo_create(surface.get()));
    const RsvgRectangle whole{0, 0, width, height};
    GError* error = nullptr;
    if (!librsvg().rsvg_handle_render_document(handle.get(), context.get(), &whole, &error)) {
        throw Error("a picture cannot be drawn: " + message_of(error));
    }
    require_success(librsvg().cairo_status(context.get()));
    return surface;
}

/// Fontconfig reads its nested configuration with several files open at once, and passes over what
/// it cannot open: letters would look otherwise.
void require_free_descriptors() {
    constexpr std::size_t kNeeded = 8;
    std::vector<int> open;
    while (open.size() < kNeeded) {
        const int fd = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        if (fd < 0) break;
        open.push_back(fd);
    }
    const int error_number = errno;
    for (const int fd : open) ::close(fd);
    if (open.size() == kNeeded) return;
    throw Error(fmt::format(
        "a picture cannot be drawn: its letters need {} open files, of which {} can be had: {}",
        kNeeded, open.size(), std::generic_category().message(error_number)));
}

/// Columns of a letter's picture that are not empty.
int inked_columns(char letter, const char* weight) {
    const Owned<cairo_surface_t> surface =
        draw(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"48\" height=\"32\">"
                         "<text x=\"8\" y=\"24\" font-family=\"sans-serif\" font-size=\"20\" "
                         "font-weight=\"{}\">{}</text></svg>",
                         weight, letter),
             1);
    librsvg().cairo_surface_flush(surface.get());
    const unsigned char* const data = librsvg().cairo_image_surface_get_data(surface.get());
    const int width = librsvg().cairo_image_surface_get_width(surface.get());
    const int height = librsvg().cairo_image_surface_get_height(surface.get());
    const int stride = librsvg().cairo_image_surface_get_stride(surface.get());
    int columns = 0;
    for (int x = 0; x < width; ++x) {
        bool inked = false;
        for (int y = 0; y < height; ++y) {
            std::uint32_t argb = 0;
            std::memcpy(&argb, data + y * stride + 4 * x, sizeof argb);
            inked |= argb != 0;
        }
        columns += inked;
    }
    return columns;
}

/// librsvg leaves letters out for which it finds no font, or draws a box for each, nearly the same: a
/// dot and a wide letter tell that from writing.
void require_fonts() {
    require_free_descriptors();
    for (const char* weight : {"normal", "bold"}) {
        const int narrow = inked_columns('.', weight), wide = inked_columns('W', weight);
        if (narrow > 0 && wide > 2 * narrow) continue;
        throw Error(
            fmt::format("a picture cannot be drawn: no font for its letters (sans-serif, {}) was "
                        "found; see what `fc-match sans-serif` says",
                        weight));
    }
}

}  // namespace

std::string png_of_svg(std::string_view svg, double scale) {
    require_in_range(scale, 0.01, 100, "scale of a picture");
    if (svg.find("<text") != std::string_view::npos) require_fonts();
    const Owned<cairo_surface_t> surface = draw(svg, scale);
    std::string png;
    require_success(librsvg().cairo_surface_write_to_png_stream(surface.get(), append, &png));
    return png;
}

}  // namespace nacre::report
