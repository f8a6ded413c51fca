// Fog, coverage, alpha test and clip planes: their part of the key, and their blocks.
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

Coverage coverage_of(const RasterState& raster, GLenum mode) {
  if (mode >= GL_TRIANGLES && raster.polygon.stipple_enabled) return Coverage::kPolygonStipple;
  if (mode == GL_POINTS && raster.point.smooth_enabled) return Coverage::kSmoothPoint;
  return Coverage::kWhole;
}

void DrawInputs::choose_fragments(const Context& context, const VertexLayout& layout) {
  key.fragments.clip_planes = context.transform.clip.enabled;
  const ColorBufferState& colors = context.raster.color_buffer;
  if (colors.alpha_test_enabled && colors.alpha_function != GL_ALWAYS)
    key.fragments.alpha = static_cast<AlphaFunction>(colors.alpha_function - GL_NEVER +
                                                     static_cast<GLenum>(AlphaFunction::kNever));
  if (!context.fog.enabled) return;
  switch (context.fog.mode) {
    case GL_LINEAR: key.fragments.fog = FogMode::kLinear; break;
    case GL_EXP: key.fragments.fog = FogMode::kExp; break;
    default: key.fragments.fog = FogMode::kExp2;
  }
  key.fragments.fog_coordinate = (layout.fields & kFieldFogCoord) != 0;
}

void DrawInputs::fill_fragments(const Context& context) {
  if (key.fragments.has_fog() || key.fragments.has_alpha_test()) {
    stale[kFragmentsBlock] = true;
    const FogState& fog = context.fog;
    const glm::mat4& modelview = context.transform.modelview.top().single;
    fragments.eye_depth = {modelview[0][2], modelview[1][2], modelview[2][2], modelview[3][2]};
    fragments.fog_color = glm::clamp(fog.color, 0.0f, 1.0f);
    const double range = static_cast<double>(fog.end) - static_cast<double>(fog.start);
    const double density = static_cast<double>(fog.density);
    double x = 0, y = 0;
    switch (key.fragments.fog) {
      case FogMode::kNone: break;
      case FogMode::kLinear:  // where start is end, what the reference takes
        x = range == 0 ? -1 : 1 / range;
        y = static_cast<double>(fog.end) * x;
        break;
      case FogMode::kExp: x = density * std::numbers::log2e; break;
      case FogMode::kExp2: x = density * std::sqrt(std::numbers::log2e); break;
    }
    fragments.fog_parameters = {finite(x), finite(y), 0,
                                context.raster.color_buffer.alpha_reference};
  }
  const PolygonStipple& stipple = context.raster.polygon_stipple;
  if (context.raster.polygon.stipple_enabled && polygon_stipple.rows != stipple) {
    stale[kPolygonStippleBlock] = true;
    polygon_stipple.rows = stipple;
  }
  if (key.fragments.clip_planes) {
    stale[kClipPlanesBlock] = true;
    const glm::dmat4 to_eye = glm::inverse(glm::dmat4(context.transform.projection.top().exact));
    for (unsigned i = 0; i < kMaxClipPlanes; ++i) {
      const glm::dvec4 plane = context.transform.clip.planes_eye[i] * to_eye;
      clip_planes.planes[i] = finite(glm::dvec3(plane), plane.w);
    }
  }
}

}  // namespace legacy_gl
