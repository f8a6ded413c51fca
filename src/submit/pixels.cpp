// Pixel rectangles (GL 2.1 spec 3.6.4).
#include "submit/pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shadergen/attributes.hpp"
#include "submit/pixel_quads.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// The whole pixels whose centres lie between the two, or on the lower one.
struct Covered {
  GLint first, end;
};
Covered covered_pixels(float a, float b) {
  const auto edge = [](float at) {
    return static_cast<GLint>(
        std::ceil(std::clamp(at, 0.0f, static_cast<float>(kPixelWindow)) - 0.5f));
  };
  return {edge(std::min(a, b)), edge(std::max(a, b))};
}

/// Two triangles.
std::vector<float> pixel_quad(const PixelRectangle& at, float s, const RasterPosition& raster) {
  std::vector<float> vertices;
  const auto corner = [&](GLint dx, GLint dy) {
    append_pixel_vertex(vertices, static_cast<float>(at.x + dx), static_cast<float>(at.y + dy), s,
                        0, raster);
  };
  corner(0, 0);
  corner(at.width, 0);
  corner(at.width, at.height);
  corner(0, 0);
  corner(at.width, at.height);
  corner(0, at.height);
  return vertices;
}

/// Only the scissor and the write mask concern stencil indices.
RasterState stencil_raster(const RasterState& raster, GLuint bits, bool set) {
  RasterState stencil = pixel_raster(raster);
  stencil.depth.test_enabled = false;
  stencil.color_buffer.write_mask = {};
  stencil.multisample.alpha_to_coverage = stencil.multisample.coverage = false;
  stencil.stencil.test_enabled = true;
  stencil.stencil.function = GL_ALWAYS;
  stencil.stencil.reference = set ? 0xff : 0;
  stencil.stencil.fail = stencil.stencil.depth_fail = stencil.stencil.depth_pass = GL_REPLACE;
  stencil.stencil.write_mask = raster.stencil.write_mask & bits;
  return stencil;
}

/// Depths of GL_DEPTH_STENCIL: only the scissor and the write mask concern them (GL 3.0
/// spec 4.3.1).
RasterState depth_raster(const RasterState& raster) {
  RasterState depth = pixel_raster(raster);
  depth.depth.test_enabled = true;
  depth.depth.function = GL_ALWAYS;
  depth.stencil.test_enabled = false;
  depth.color_buffer.write_mask = {};
  depth.multisample.alpha_to_coverage = depth.multisample.coverage = false;
  return depth;
}

void load_tile(Context& context, const PixelImage& image, const PixelTile& tile,
               const glm::vec4& place) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  objects.textures.select_unit(kPixelTextureUnit);
  driver.BindSampler(kPixelTextureUnit, 0);
  objects.pixel_texture.load(image, tile);
  driver.VertexAttrib4fv(kLocationPixelPlace, &place[0]);
}

/// No shader of OpenGL 3.3 writes stencil values: all bits are cleared, and then one is set after
/// the other where the indices have it.
void draw_stencil(Context& context, const PixelRectangle& covered) {
  const RasterPosition& raster = context.current.raster;
  const auto draw = [&](GLuint value, GLuint bits) {
    draw_pixel_quads(context, PixelSource::kStencil,
                     pixel_quad(covered, static_cast<float>(value), raster),
                     stencil_raster(context.raster, bits, value != 0), nullptr);
  };
  draw(0, 0xff);
  for (unsigned bit = 0; bit < 8; ++bit)
    if (context.raster.stencil.write_mask >> bit & 1u) draw(1u << bit, 1u << bit);
}

void draw_tile(Context& context, const PixelImage& image, const PixelTile& tile) {
  const RasterPosition& raster = context.current.raster;
  const PixelTransfer& transfer = context.pixels.transfer;
  // To whole pixels, as the reference rounds: row D20 of docs/deviations.md.
  const float left = std::round(raster.position.x) + transfer.zoom_x * static_cast<float>(tile.x);
  const float bottom = std::round(raster.position.y) + transfer.zoom_y * static_cast<float>(tile.y);
  const Covered x = covered_pixels(left, left + transfer.zoom_x * static_cast<float>(tile.width));
  const Covered y =
      covered_pixels(bottom, bottom + transfer.zoom_y * static_cast<float>(tile.height));
  if (x.first >= x.end || y.first >= y.end) return;
  load_tile(context, image, tile, {left, bottom, transfer.zoom_x, transfer.zoom_y});
  const PixelRectangle covered{x.first, y.first, x.end - x.first, y.end - y.first};
  if (image.source == PixelSource::kStencil) return draw_stencil(context, covered);
  if (image.written_only)
    return draw_pixel_quads(context, image.source, pixel_quad(covered, 0, raster),
                            depth_raster(context.raster), nullptr);
  draw_pixel_quads(context, image.source, pixel_quad(covered, 0, raster),
                   pixel_raster(context.raster), &raster.texture_coordinates);
}
}  // namespace

void write_colors(Context& context, const PixelRectangle& area, const std::vector<float>& colors) {
  RasterState raster = pixel_raster(context.raster);
  raster.depth.test_enabled = raster.stencil.test_enabled = false;
  raster.color_buffer.blend_enabled = raster.color_buffer.logic_op_enabled = false;
  raster.multisample.alpha_to_coverage = raster.multisample.coverage = false;
  constexpr GLsizei kSide = PixelTexture::kMaxSide;
  PixelImage image{PixelSource::kColors, area.width, area.height, {}};
  image.texels.type = Texels::Type::kFloats;
  image.texels.data.resize(colors.size() * sizeof(float));
  std::memcpy(image.texels.data.data(), colors.data(), image.texels.data.size());
  for (GLsizei y = 0; y < area.height; y += kSide)
    for (GLsizei x = 0; x < area.width; x += kSide) {
      const PixelRectangle part{area.x + x, area.y + y, std::min(kSide, area.width - x),
                                std::min(kSide, area.height - y)};
      load_tile(context, image, {x, y, part.width, part.height},
                {static_cast<float>(part.x), static_cast<float>(part.y), 1, 1});
      draw_pixel_quads(context, image.source, pixel_quad(part, 0, RasterPosition{}), raster,
                       nullptr);
    }
}

void draw_pixels(Context& context, const PixelImage& image) {
  constexpr GLsizei kSide = PixelTexture::kMaxSide;
  for (GLsizei y = 0; y < image.height; y += kSide)
    for (GLsizei x = 0; x < image.width; x += kSide)
      draw_tile(context, image,
                {x, y, std::min(kSide, image.width - x), std::min(kSide, image.height - y)});
}

}  // namespace legacy_gl
