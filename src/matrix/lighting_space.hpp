#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "matrix/matrix_stack.hpp"

namespace legacy_gl {

/// What the modelview's upper 3×3 is good for; computed once per change of it (a translation does
/// not change it).
struct LinearPart {
  glm::dmat3 matrix{1.0};
  bool keeps_angles = true;     ///< nearly a rotation or reflection times one scale
  double scale = 1;             ///< that scale
  glm::dmat3 angle_error{0.0};  ///< scale^2 × inverse × inverse transpose - identity: what it lacks
  bool exact = true;            ///< angle_error is below what float32 shows
  glm::dmat3 inverse{1.0};      ///< zero when the matrix is singular
  glm::dmat3 cofactor{1.0};     ///< determinant × inverse transpose, largest entry 1/8 to 1/4:
                                ///< any normal times it is a number
  double determinant_sign = 1;
  glm::dmat3 inverse_transpose{1.0};  ///< zero when the matrix is singular
  double rescale_factor = 1;          ///< GL 2.1 spec 2.11.3, "f"
};

LinearPart analyse(const glm::dmat3& matrix);

/// The last row is (0, 0, 0, 1).
bool is_affine(const glm::dmat4& matrix);

}  // namespace legacy_gl
