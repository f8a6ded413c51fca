// GLU 1.3 specification 6.4, gluCylinder.
#include <algorithm>

#include "glu/directions.hpp"
#include "glu/quadric.hpp"

namespace legacy_gl::glu {
namespace {

class Cylinder {
 public:
  Cylinder(const GLUquadric& quadric, double base, double top, double height, int slices,
           int stacks)
      : quadric_(quadric),
        base_(base),
        height_(height),
        radius_decrease_(static_cast<float>(base - top)),
        slope_length_(slope_length(radius_decrease_, height)),
        slice_count_(slices),
        stack_count_(stacks),
        slices_(Directions::full_turn(slices, 0.0)),
        smooth_normals_(Directions::full_turn(slices, 0.0, radial_part())),
        facet_normals_(Directions::full_turn(slices, -0.5, radial_part())) {}

  // A cylinder of no height between equal radii has no surface and no normals.
  bool is_empty() const { return slope_length_ == 0.0F; }

  void fill() const {
    for (int band = 0; band < stack_count_; ++band) {
      const int first = quadric_.inside() ? band + 1 : band;
      const int second = quadric_.inside() ? band : band + 1;
      lglBegin(GL_QUAD_STRIP);
      for (int slice = 0; slice <= slice_count_; ++slice) {
        normal(slice, facet_normals_);
        vertex(slice, first);
        vertex(slice, second);
      }
      lglEnd();
    }
  }

  // The silhouette is the two rims and the generating lines.
  void lines(bool silhouette) const {
    if (!silhouette) {
      for (int stack = 1; stack < stack_count_; ++stack) {
        ring(stack);
      }
    }
    ring(0);
    ring(stack_count_);
    for (int slice = 0; slice < slice_count_; ++slice) {
      if (quadric_.normals != GLU_NONE) {
        // Towards the axis even on a cone, as libGLU has it, and smooth even when flat.
        lglNormal3f(smooth_normals_[slice].sine, smooth_normals_[slice].cosine, 0.0F);
      }
      lglBegin(GL_LINE_STRIP);
      for (int stack = 0; stack <= stack_count_; ++stack) {
        vertex(slice, stack);
      }
      lglEnd();
    }
  }

  void points() const {
    lglBegin(GL_POINTS);
    for (int slice = 0; slice < slice_count_; ++slice) {
      // A point is no facet, so it has the normal of the cylinder.
      normal(slice, smooth_normals_);
      for (int stack = 0; stack <= stack_count_; ++stack) {
        vertex(slice, stack);
      }
    }
    lglEnd();
  }

 private:
  void ring(int stack) const {
    lglBegin(GL_LINE_STRIP);
    for (int slice = 0; slice <= slice_count_; ++slice) {
      normal(slice, facet_normals_);
      vertex(slice, stack);
    }
    lglEnd();
  }

  static float slope_length(float radius_decrease, double height) {
    const double decrease = static_cast<double>(radius_decrease);
    return static_cast<float>(std::sqrt(decrease * decrease + height * height));
  }

  // The length of a normal's projection onto the base, with the sign of the orientation.
  double radial_part() const {
    const float radial = static_cast<float>(height_ / static_cast<double>(slope_length_));
    return static_cast<double>(quadric_.normal_sign() * radial);
  }

  void normal(int slice, const Directions& flat_normals) const {
    if (quadric_.normals == GLU_NONE) {
      return;
    }
    const Direction& at =
        quadric_.normals == GLU_FLAT ? flat_normals[slice] : smooth_normals_[slice];
    // libGLU does not turn the z of the normal with GLU_INSIDE; the pictures of cones depend on it.
    lglNormal3f(at.sine, at.cosine, radius_decrease_ / slope_length_);
  }

  void vertex(int slice, int stack) const {
    const float fraction = static_cast<float>(stack) / static_cast<float>(stack_count_);
    quadric_.texture_coordinate(1.0F - static_cast<float>(slice) / static_cast<float>(slice_count_),
                                fraction);
    const float radius =
        static_cast<float>(base_ - static_cast<double>(radius_decrease_ * fraction));
    const float z = static_cast<float>(height_ * stack / stack_count_);
    lglVertex3f(radius * slices_[slice].sine, radius * slices_[slice].cosine, z);
  }

  const GLUquadric& quadric_;
  double base_;
  double height_;
  float radius_decrease_;
  float slope_length_;
  int slice_count_;
  int stack_count_;
  Directions slices_;
  Directions smooth_normals_;
  Directions facet_normals_;
};

}  // namespace
}  // namespace legacy_gl::glu

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluCylinder(GLUquadric* quadric, GLdouble base, GLdouble top,
                                                   GLdouble height, GLint slices, GLint stacks) {
  using namespace legacy_gl::glu;
  if (slices < 2 || stacks < 1 || base < 0.0 || top < 0.0 || height < 0.0) {
    quadric->report(GLU_INVALID_VALUE);
    return;
  }
  const Cylinder cylinder(*quadric, base, top, height, std::min(slices, max_segment_count), stacks);
  if (cylinder.is_empty()) {
    quadric->report(GLU_INVALID_VALUE);
    return;
  }
  switch (quadric->draw_style) {
    case GLU_FILL: cylinder.fill(); break;
    case GLU_POINT: cylinder.points(); break;
    default: cylinder.lines(quadric->draw_style == GLU_SILHOUETTE); break;
  }
}
