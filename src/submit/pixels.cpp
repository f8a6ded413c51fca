// Bitmaps and pixel rectangles: quads in window coordinates, whose fragments go the way of all
// others (GL 2.1 spec 3.6.4, 3.7).
#include <algorithm>
#include <cmath>
#include <cstring>

#include "shadergen/attributes.hpp"
#include "submit/backend.hpp"

namespace legacy_gl {

namespace {

/// Position with w; the texel in the place of the normal; the raster position's colours.
VertexLayout pixel_layout() {
  VertexLayout layout;
  layout.fields =
      kFieldPositionW | kFieldNormal | kFieldColor | kFieldSecondaryColor | kFieldFogCoord;
  return layout;
}

/// Neither viewport nor culling nor polygon offset concern pixel rectangles.
RasterState pixel_raster(const RasterState& raster) {
  RasterState pixels = raster;
  pixels.viewport = {{0, 0, kPixelWindow, kPixelWindow}, 0, 1};
  pixels.polygon = {};
  return pixels;
}

/// Units, whose coordinates are the raster position's: generated and transformed when it was set.
TextureKey pixel_textures(const TextureKey& textures, const RasterTextureCoordinates& coordinates) {
  TextureKey key = textures;
  key.normalize = false;
  for (unsigned unit = 0; unit < key.count; ++unit) {
    TextureStageKey& stage = key.stages[unit];
    stage.sources = {};
    stage.matrix = false;
    stage.projective = stage.kind != TextureKind::kNone && stage.kind != TextureKind::kCube &&
                       coordinates[unit].w != 1;
  }
  return key;
}

/// What of the state's key still matters. The distance is the raster position's.
ProgramKey pixel_key(const Context& context, const ProgramKey& state, PixelSource source,
                     const RasterTextureCoordinates& coordinates) {
  ProgramKey key;
  key.pixels = source;
  const FragmentKey& fragments = state.fragments;
  key.textures = pixel_textures(state.textures, coordinates);
  key.fragments = fragments;
  key.fragments.clip_planes = 0;
  key.fragments.fog_coordinate = fragments.has_fog();
  key.secondary_from_vertex = context.color_sum_enabled ||
                              (context.lighting.enabled &&
                               context.lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR);
  return key;
}

}  // namespace

void Backend::draw_pixel_quads(Context& context, PixelSource source,
                               const std::vector<float>& vertices, const RasterState& raster,
                               const RasterTextureCoordinates* coordinates) {
  const VertexLayout layout = pixel_layout();
  const std::size_t stride = offsets_of(layout).stride * sizeof(float);
  derive(context, Recorder::relevant_layout(context));
  upload_uniforms(context);
  const auto count = static_cast<GLsizei>(vertices.size() * sizeof(float) / stride);
  ProgramKey key;
  key.pixels = source;
  if (coordinates) key = pixel_key(context, derived_.key, source, *coordinates);
  if (!use_program(context, key, static_cast<std::uint64_t>(count))) return;
  if (key.textures.count) textures_.bind(active_textures(context));
  for (unsigned unit = 0; unit < key.textures.count; ++unit)
    driver.VertexAttrib4fv(texcoord_location(unit), &(*coordinates)[unit][0]);
  raster_.apply(driver, raster, 0);
  context.dirty |= kDirtyRaster;  // the viewport of other primitives returns with the next draw
  const std::size_t offset =
      vertices_.write(vertices.data(), vertices.size() * sizeof(float), stride);
  bind_vertex_array(arrays_.find_or_build(layout, vertices_.name(), indices_.name()));
  driver.DrawArrays(GL_TRIANGLES, static_cast<GLint>(offset / stride), count);
  ++context.statistics.draws;
  ++context.statistics.batches;
}

void Backend::draw_bitmaps(Context& context) {
  context.bitmaps_pending = false;
  textures_.select_unit(kPixelTextureUnit);
  bitmaps_.bind();
  draw_pixel_quads(context, PixelSource::kBitmap, bitmaps_.vertices(), pixel_raster(context.raster),
                   &bitmap_texture_coordinates_);
  bitmaps_.clear();
}

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

}  // namespace

/// GL 2.1 spec 4.2.4: only the scissor, the colour mask and dithering concern what returns.
void Backend::return_accumulation(Context& context, const PixelRectangle& area, float factor) {
  const std::vector<float> colors = accumulation_.scaled(area, factor);
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
      load_tile(image, {x, y, part.width, part.height},
                {static_cast<float>(part.x), static_cast<float>(part.y), 1, 1});
      draw_pixel_quads(context, image.source, pixel_quad(part, 0, RasterPosition{}), raster,
                       nullptr);
    }
}

void Backend::load_tile(const PixelImage& image, const PixelTile& tile, const glm::vec4& place) {
  textures_.select_unit(kPixelTextureUnit);
  driver.BindSampler(kPixelTextureUnit, 0);
  pixel_texture_.load(image, tile);
  driver.VertexAttrib4fv(kLocationPixelPlace, &place[0]);
}

/// No shader of OpenGL 3.3 writes stencil values: all bits are cleared, and then one is set after
/// the other where the indices have it.
void Backend::draw_stencil(Context& context, const PixelRectangle& covered) {
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

void Backend::draw_tile(Context& context, const PixelImage& image, const PixelTile& tile) {
  const RasterPosition& raster = context.current.raster;
  const PixelTransfer& transfer = context.pixels.transfer;
  // To whole pixels, as the reference rounds: row D20 of docs/deviations.md.
  const float left = std::round(raster.position.x) + transfer.zoom_x * static_cast<float>(tile.x);
  const float bottom = std::round(raster.position.y) + transfer.zoom_y * static_cast<float>(tile.y);
  const Covered x = covered_pixels(left, left + transfer.zoom_x * static_cast<float>(tile.width));
  const Covered y =
      covered_pixels(bottom, bottom + transfer.zoom_y * static_cast<float>(tile.height));
  if (x.first >= x.end || y.first >= y.end) return;
  load_tile(image, tile, {left, bottom, transfer.zoom_x, transfer.zoom_y});
  const PixelRectangle covered{x.first, y.first, x.end - x.first, y.end - y.first};
  if (image.source == PixelSource::kStencil) return draw_stencil(context, covered);
  if (image.written_only)
    return draw_pixel_quads(context, image.source, pixel_quad(covered, 0, raster),
                            depth_raster(context.raster), nullptr);
  draw_pixel_quads(context, image.source, pixel_quad(covered, 0, raster),
                   pixel_raster(context.raster), &raster.texture_coordinates);
}

void Backend::draw_pixels(Context& context, const PixelImage& image) {
  constexpr GLsizei kSide = PixelTexture::kMaxSide;
  for (GLsizei y = 0; y < image.height; y += kSide)
    for (GLsizei x = 0; x < image.width; x += kSide)
      draw_tile(context, image,
                {x, y, std::min(kSide, image.width - x), std::min(kSide, image.height - y)});
}

void Backend::add_bitmap(Context& context, GLint x, GLint y, const BitmapImage& image) {
  const RasterTextureCoordinates& coordinates = context.current.raster.texture_coordinates;
  if (!context.bitmaps_pending) {
    bitmap_texture_coordinates_ = coordinates;
  } else if (active_textures(context).mask && bitmap_texture_coordinates_ != coordinates) {
    draw_bitmaps(context);
    bitmap_texture_coordinates_ = coordinates;
  }
  constexpr GLsizei kSide = Bitmaps::kMaxSide;
  for (GLsizei top = 0; top < image.height; top += kSide)
    for (GLsizei left = 0; left < image.width; left += kSide) {
      const GLsizei width = std::min(kSide, image.width - left);
      const GLsizei height = std::min(kSide, image.height - top);
      const bool whole = width == image.width && height == image.height;
      const BitmapImage part = whole ? BitmapImage{} : image.part(left, top, width, height);
      const auto add = [&] {
        return bitmaps_.add(context.current.raster, x + left, y + top, whole ? image : part);
      };
      if (!add()) {
        if (context.bitmaps_pending) draw_bitmaps(context);
        bitmaps_.forget();
        add();
      }
      context.bitmaps_pending = true;
    }
}

}  // namespace legacy_gl
