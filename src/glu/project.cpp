// GLU 1.3 specification 4.2.
#include <legacy_gl/glu.h>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

namespace {

struct Viewport {
  glm::dvec2 origin;
  glm::dvec2 size;
};

Viewport viewport_from(const GLint* viewport) {
  return {{viewport[0], viewport[1]}, {viewport[2], viewport[3]}};
}

struct DepthRange {
  double near = 0.0;
  double far = 1.0;
};

std::optional<glm::dvec4> object_from_window(const glm::dvec3& window, double clip_w,
                                             const GLdouble* modelview, const GLdouble* projection,
                                             const Viewport& viewport, const DepthRange& range) {
  const glm::dmat4 object_to_clip = glm::make_mat4(projection) * glm::make_mat4(modelview);
  if (glm::determinant(object_to_clip) == 0.0) {
    return std::nullopt;
  }
  const glm::dvec2 device_xy = 2.0 * (glm::dvec2(window) - viewport.origin) / viewport.size - 1.0;
  const double device_z = 2.0 * (window.z - range.near) / (range.far - range.near) - 1.0;
  return glm::inverse(object_to_clip) * glm::dvec4(device_xy, device_z, clip_w);
}

}  // namespace

LEGACY_GL_API GLint LEGACY_GL_APIENTRY lgluProject(GLdouble object_x, GLdouble object_y,
                                                   GLdouble object_z, const GLdouble* modelview,
                                                   const GLdouble* projection,
                                                   const GLint* viewport, GLdouble* window_x,
                                                   GLdouble* window_y, GLdouble* window_z) {
  const glm::dvec4 eye = glm::make_mat4(modelview) * glm::dvec4(object_x, object_y, object_z, 1.0);
  const glm::dvec4 clip = glm::make_mat4(projection) * eye;
  if (clip.w == 0.0) {
    return GLU_FALSE;
  }
  const glm::dvec3 unit_cube = glm::dvec3(clip) / clip.w * 0.5 + 0.5;
  const Viewport view = viewport_from(viewport);
  *window_x = unit_cube.x * view.size.x + view.origin.x;
  *window_y = unit_cube.y * view.size.y + view.origin.y;
  *window_z = unit_cube.z;
  return GLU_TRUE;
}

LEGACY_GL_API GLint LEGACY_GL_APIENTRY lgluUnProject(GLdouble window_x, GLdouble window_y,
                                                     GLdouble window_z, const GLdouble* modelview,
                                                     const GLdouble* projection,
                                                     const GLint* viewport, GLdouble* object_x,
                                                     GLdouble* object_y, GLdouble* object_z) {
  const std::optional<glm::dvec4> object =
      object_from_window({window_x, window_y, window_z}, 1.0, modelview, projection,
                         viewport_from(viewport), DepthRange{});
  if (!object || object->w == 0.0) {
    return GLU_FALSE;
  }
  *object_x = object->x / object->w;
  *object_y = object->y / object->w;
  *object_z = object->z / object->w;
  return GLU_TRUE;
}

LEGACY_GL_API GLint LEGACY_GL_APIENTRY
lgluUnProject4(GLdouble window_x, GLdouble window_y, GLdouble window_z, GLdouble clip_w,
               const GLdouble* modelview, const GLdouble* projection, const GLint* viewport,
               GLdouble range_near, GLdouble range_far, GLdouble* object_x, GLdouble* object_y,
               GLdouble* object_z, GLdouble* object_w) {
  const std::optional<glm::dvec4> object =
      object_from_window({window_x, window_y, window_z}, clip_w, modelview, projection,
                         viewport_from(viewport), DepthRange{range_near, range_far});
  if (!object) {
    return GLU_FALSE;
  }
  *object_x = object->x;
  *object_y = object->y;
  *object_z = object->z;
  *object_w = object->w;
  return GLU_TRUE;
}
