// All uses of librsvg and cairo are in this file.
#include "picture_module.hpp"

#include <cairo-pdf.h>
#include <cairo.h>
#include <cmath>
#include <librsvg/rsvg.h>
#include <memory>
#include <stdexcept>

namespace higherpair::cli {
namespace {

template <auto kFree>
struct Freed {
  template <class T>
  void operator()(T* pointer) const {
    kFree(pointer);
  }
};
using Handle = std::unique_ptr<RsvgHandle, Freed<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Freed<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Freed<cairo_destroy>>;

constexpr double kPointsPerPx = 0.75;
constexpr double kPixelsPerPx = 2;

// A picture as read by librsvg, and its size in px.
struct Picture {
  Handle handle;
  double width = 0;
  double height = 0;
};

[[noreturn]] void fail(GError* error) {
  const std::string message = error != nullptr ? error->message : "unknown error";
  g_clear_error(&error);
  throw std::runtime_error("cannot convert the picture: " + message);
}

Picture read(const std::string& svg) {
  GError* error = nullptr;
  Picture picture;
  picture.handle.reset(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (!picture.handle) {
    fail(error);
  }
  rsvg_handle_set_dpi(picture.handle.get(), 96);
  rsvg_handle_get_intrinsic_size_in_pixels(picture.handle.get(), &picture.width, &picture.height);
  return picture;
}

cairo_status_t append(void* out, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("cannot convert the picture: ") + cairo_status_to_string(status));
  }
}

void render(const Picture& picture, cairo_surface_t* surface, double scale) {
  const Context context(cairo_create(surface));
  cairo_scale(context.get(), scale, scale);
  const RsvgRectangle viewport = {0, 0, picture.width, picture.height};
  GError* error = nullptr;
  if (rsvg_handle_render_document(picture.handle.get(), context.get(), &viewport, &error) == 0) {
    fail(error);
  }
  check(cairo_status(context.get()));
}

}  // namespace

}  // namespace higherpair::cli

void higherpair_pdf_of(const std::string& svg, std::string& pdf) {
  using namespace higherpair::cli;
  const Picture picture = read(svg);
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &pdf, picture.width * kPointsPerPx,
                                                            picture.height * kPointsPerPx));
  render(picture, surface.get(), kPointsPerPx);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
}

void higherpair_png_of(const std::string& svg, std::string& png) {
  using namespace higherpair::cli;
  const Picture picture = read(svg);
  const Surface surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(std::lround(picture.width * kPixelsPerPx)),
      static_cast<int>(std::lround(picture.height * kPixelsPerPx))));
  check(cairo_surface_status(surface.get()));
  render(picture, surface.get(), kPixelsPerPx);
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
}
