// GLU 1.3 specification 4.1. The arithmetic has the precision libGLU's has (double for the
// projection, float for the view), so that both hand the GL the same numbers.
#include <legacy_gl/glu.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace {

// A zero vector stays zero: a view without a direction gives a singular matrix, not NaNs.
glm::vec3 unit_or_zero(const glm::vec3& v) {
  const float length = glm::length(v);
  return length == 0.0F ? v : v / length;
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPerspective(GLdouble fov_y_degrees, GLdouble aspect,
                                                      GLdouble near_distance,
                                                      GLdouble far_distance) {
  const double half_angle = fov_y_degrees / 2.0 * M_PI / 180.0;
  const double depth = far_distance - near_distance;
  const double sine = std::sin(half_angle);
  if (depth == 0.0 || sine == 0.0 || aspect == 0.0) {
    return;
  }
  const double cotangent = std::cos(half_angle) / sine;

  glm::dmat4 projection(0.0);
  projection[0][0] = cotangent / aspect;
  projection[1][1] = cotangent;
  projection[2][2] = -(far_distance + near_distance) / depth;
  projection[2][3] = -1.0;
  projection[3][2] = -2.0 * near_distance * far_distance / depth;
  lglMultMatrixd(glm::value_ptr(projection));
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluLookAt(GLdouble eye_x, GLdouble eye_y, GLdouble eye_z,
                                                 GLdouble center_x, GLdouble center_y,
                                                 GLdouble center_z, GLdouble up_x, GLdouble up_y,
                                                 GLdouble up_z) {
  const glm::dvec3 eye(eye_x, eye_y, eye_z);
  const glm::vec3 forward = unit_or_zero(glm::vec3(glm::dvec3(center_x, center_y, center_z) - eye));
  const glm::vec3 side = unit_or_zero(glm::cross(forward, glm::vec3(glm::dvec3(up_x, up_y, up_z))));
  const glm::vec3 up = glm::cross(side, forward);

  const glm::mat3 eye_to_object(side, up, -forward);
  lglMultMatrixf(glm::value_ptr(glm::mat4(glm::transpose(eye_to_object))));
  lglTranslated(-eye.x, -eye.y, -eye.z);
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluOrtho2D(GLdouble left, GLdouble right, GLdouble bottom,
                                                  GLdouble top) {
  lglOrtho(left, right, bottom, top, -1.0, 1.0);
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPickMatrix(GLdouble x, GLdouble y, GLdouble width,
                                                     GLdouble height, GLint* viewport) {
  if (width <= 0.0 || height <= 0.0) {
    return;
  }
  const glm::dvec2 region(width, height);
  const glm::dvec2 origin(viewport[0], viewport[1]);
  const glm::dvec2 size(viewport[2], viewport[3]);
  const glm::vec2 offset((size - 2.0 * (glm::dvec2(x, y) - origin)) / region);
  const glm::vec2 scale(size / region);
  lglTranslatef(offset.x, offset.y, 0.0F);
  lglScalef(scale.x, scale.y, 1.0F);
}
