#include "cpu_pipeline/raster_position.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cpu_pipeline/lit_vertex.hpp"
#include "cpu_pipeline/texture_coordinates.hpp"
#include "execute/lighting_setters.hpp"
#include "geometry/window_coordinates.hpp"
#include "record/pending.hpp"

namespace legacy_gl::execute {

namespace {

bool in_view_volume(const glm::vec4& clip) {
  const auto within = [&](float value) { return value >= -clip.w && value <= clip.w; };
  return within(clip.x) && within(clip.y) && within(clip.z);
}

/// GL 2.1 spec 2.12.
bool before_clip_planes(const ClipPlanes& clip, const glm::vec4& eye) {
  for (unsigned i = 0; i < kMaxClipPlanes; ++i)
    if (clip.enabled >> i & 1 && glm::dot(clip.planes_eye[i], glm::dvec4(eye)) < 0) return false;
  return true;
}

/// A valid raster position hits as a point does (GL 2.1 spec 5.2).
void hit(Context& c) {
  if (!c.selection.is_selecting()) return;
  flush_pending(c);
  c.selection.add_hit(c.current.raster.position.z);
}

float fog_distance(const Context& c, float distance) {
  return c.fog.coordinate_source == GL_FOG_COORD ? c.current.fog_coordinate : distance;
}

}  // namespace

void raster_position(Context& c, float x, float y, float z, float w) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  RasterPosition& raster = c.current.raster;
  const glm::vec4 object(x, y, z, w);
  const glm::vec4 eye = c.transform.modelview.top().single * object;
  const glm::vec4 clip = c.transform.projection.top().single * eye;
  raster.valid = in_view_volume(clip) && before_clip_planes(c.transform.clip, eye);
  if (!raster.valid) return;
  raster.position = glm::vec4(to_window(c.raster.viewport, clip), clip.w);
  raster.distance = fog_distance(c, glm::length(glm::vec3(eye)));
  hit(c);
  if (c.lighting.enabled) {
    latch_color_material(c);
    const LitColor lit = light_vertex(c, c.lighting.materials, object, c.current.normal, kFront);
    raster.color = lit.primary;
    raster.secondary_color = lit.secondary;
  } else {
    raster.color = c.current.color;
    raster.secondary_color = glm::vec3(c.current.secondary_color);
  }
  raster.index = c.current.index;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    raster.texture_coordinates[unit] = transformed_texture_coordinates(
        c, unit, object, c.current.normal, c.current.texture_coordinates[unit]);
}

void window_position(Context& c, float x, float y, float z) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  RasterPosition& raster = c.current.raster;
  const ViewportState& viewport = c.raster.viewport;
  const double depth = viewport.depth_near + std::clamp(static_cast<double>(z), 0.0, 1.0) *
                                                 (viewport.depth_far - viewport.depth_near);
  raster.position = {x, y, static_cast<float>(depth), 1};
  raster.valid = true;
  hit(c);
  raster.distance = fog_distance(c, 0);
  raster.color = glm::clamp(c.current.color, 0.0f, 1.0f);
  raster.secondary_color = glm::clamp(glm::vec3(c.current.secondary_color), 0.0f, 1.0f);
  raster.index = c.current.index;
  raster.texture_coordinates = c.current.texture_coordinates;
}

}  // namespace legacy_gl::execute
