#include "submit/pixel_quads.hpp"

#include "record/pending.hpp"
#include "shadergen/attributes.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// Position with w; the texel in the place of the normal; the raster position's colours.
VertexLayout pixel_layout() {
  VertexLayout layout;
  layout.fields =
      kFieldPositionW | kFieldNormal | kFieldColor | kFieldSecondaryColor | kFieldFogCoord;
  return layout;
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

RasterState pixel_raster(const RasterState& raster) {
  RasterState pixels = raster;
  pixels.viewport = {{0, 0, kPixelWindow, kPixelWindow}, 0, 1};
  pixels.polygon = {};
  return pixels;
}

void draw_pixel_quads(Context& context, PixelSource source, const std::vector<float>& vertices,
                      const RasterState& raster, const RasterTextureCoordinates* coordinates) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const VertexLayout layout = pixel_layout();
  const std::size_t stride = offsets_of(layout).stride * sizeof(float);
  update_inputs(context, Recorder::relevant_layout(context));
  submission.uniforms.upload(context, submission.inputs, submission.general_program);
  const auto count = static_cast<GLsizei>(vertices.size() * sizeof(float) / stride);
  ProgramKey key;
  key.pixels = source;
  if (coordinates) key = pixel_key(context, submission.inputs.key, source, *coordinates);
  if (!use_program(context, key, static_cast<std::uint64_t>(count))) return;
  if (key.textures.count) objects.textures.bind(active_textures(context.texture));
  for (unsigned unit = 0; unit < key.textures.count; ++unit)
    driver.VertexAttrib4fv(texcoord_location(unit), &(*coordinates)[unit][0]);
  objects.raster.apply(driver, raster, 0);
  context.dirty |= kDirtyRaster;  // the viewport of other primitives returns with the next draw
  const std::size_t offset =
      objects.vertex_stream.write(vertices.data(), vertices.size() * sizeof(float), stride);
  context.driver->bind_vertex_array(objects.vertex_arrays.find_or_build(
      layout, objects.vertex_stream.name(), objects.index_stream.name()));
  driver.DrawArrays(GL_TRIANGLES, static_cast<GLint>(offset / stride), count);
  ++context.statistics.draws;
  ++context.statistics.batches;
}

}  // namespace legacy_gl
