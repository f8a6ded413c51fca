// GLU 1.3 specification 6.4, gluSphere. x = r sin(stack) sin(slice), y = r sin(stack) cos(slice),
// z = r cos(stack): slice 0 is along +y and the slices run clockwise seen from +z; stack 0 is +z.
#include <algorithm>

#include "glu/directions.hpp"
#include "glu/quadric.hpp"

namespace legacy_gl::glu {
namespace {

class Sphere {
 public:
  Sphere(const GLUquadric& quadric, double radius, int slices, int stacks)
      : quadric_(quadric),
        slice_count_(slices),
        stack_count_(stacks),
        slices_(Directions::full_turn(slices, 0.0)),
        stacks_(stacks, 0.0, M_PI, 0.0),
        scaled_stacks_(stacks, 0.0, M_PI, 0.0, radius),
        facet_slices_(Directions::full_turn(slices, -0.5)),
        facet_stacks_(stacks, 0.0, M_PI, -0.5) {
    // The float nearest to pi has a sine; the poles are points all the same.
    scaled_stacks_[0].sine = 0.0F;
    scaled_stacks_[stacks].sine = 0.0F;
  }

  void fill() const {
    int first_band = 0;
    int end_band = stack_count_;
    if (!quadric_.has_texture) {
      // A pole is one vertex when it needs no texture coordinate of its own in each slice.
      fan(0, 1);
      fan(stack_count_, stack_count_ - 1);
      first_band = 1;
      end_band = stack_count_ - 1;
    }
    for (int band = first_band; band < end_band; ++band) {
      const int first = quadric_.inside() ? band : band + 1;
      const int second = quadric_.inside() ? band + 1 : band;
      lglBegin(GL_QUAD_STRIP);
      for (int slice = 0; slice <= slice_count_; ++slice) {
        smooth_normal(slice, first);
        vertex(slice, first);
        smooth_normal(slice, second);
        flat_normal(facet_slices_[slice], facet_stacks_[band + 1]);
        vertex(slice, second);
      }
      lglEnd();
    }
  }

  void lines() const {
    for (int stack = 1; stack < stack_count_; ++stack) {
      lglBegin(GL_LINE_STRIP);
      for (int slice = 0; slice <= slice_count_; ++slice) {
        smooth_normal(slice, stack);
        flat_normal(facet_slices_[slice], stacks_[stack]);
        vertex(slice, stack);
      }
      lglEnd();
    }
    for (int slice = 0; slice < slice_count_; ++slice) {
      lglBegin(GL_LINE_STRIP);
      for (int stack = 0; stack <= stack_count_; ++stack) {
        smooth_normal(slice, stack);
        flat_normal(slices_[slice], facet_stacks_[stack]);
        vertex(slice, stack);
      }
      lglEnd();
    }
  }

  void points() const {
    lglBegin(GL_POINTS);
    for (int stack = 0; stack <= stack_count_; ++stack) {
      for (int slice = 0; slice < slice_count_; ++slice) {
        smooth_normal(slice, stack);
        // A point is no facet, so it has the normal of the sphere.
        flat_normal(slices_[slice], stacks_[stack]);
        vertex(slice, stack);
      }
    }
    lglEnd();
  }

 private:
  // The cap between a pole's stack and the stack beside it, counter-clockwise seen from the side
  // that the normals point to.
  void fan(int pole, int rim) const {
    const bool at_top = pole == 0;
    const Direction facet_stack = facet_stacks_[std::max(pole, rim)];
    smooth_normal(0, pole);
    lglBegin(GL_TRIANGLE_FAN);
    vertex(0, pole);
    for (int i = 0; i <= slice_count_; ++i) {
      if (at_top == quadric_.inside()) {
        smooth_normal(i, rim);
        flat_normal(facet_slices_[i], facet_stack);
        vertex(i, rim);
        continue;
      }
      const int slice = slice_count_ - i;
      smooth_normal(slice, rim);
      // The first rim vertex completes no triangle; it belongs to no facet yet.
      if (i > 0) {
        flat_normal(facet_slices_[slice + 1], facet_stack);
      }
      vertex(slice, rim);
    }
    lglEnd();
  }

  void normal(const Direction& slice, const Direction& stack) const {
    const float sign = quadric_.normal_sign();
    const float ring = sign * stack.sine;
    lglNormal3f(slice.sine * ring, slice.cosine * ring, sign * stack.cosine);
  }

  void smooth_normal(int slice, int stack) const {
    if (quadric_.normals == GLU_SMOOTH) {
      normal(slices_[slice], stacks_[stack]);
    }
  }

  void flat_normal(const Direction& slice, const Direction& stack) const {
    if (quadric_.normals == GLU_FLAT) {
      normal(slice, stack);
    }
  }

  void vertex(int slice, int stack) const {
    quadric_.texture_coordinate(
        1.0F - static_cast<float>(slice) / static_cast<float>(slice_count_),
        1.0F - static_cast<float>(stack) / static_cast<float>(stack_count_));
    const Direction& at = scaled_stacks_[stack];
    lglVertex3f(at.sine * slices_[slice].sine, at.sine * slices_[slice].cosine, at.cosine);
  }

  const GLUquadric& quadric_;
  int slice_count_;
  int stack_count_;
  Directions slices_;
  Directions stacks_;
  Directions scaled_stacks_;
  Directions facet_slices_;
  Directions facet_stacks_;
};

}  // namespace
}  // namespace legacy_gl::glu

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluSphere(GLUquadric* quadric, GLdouble radius, GLint slices,
                                                 GLint stacks) {
  using namespace legacy_gl::glu;
  if (slices < 2 || stacks < 1 || radius < 0.0) {
    quadric->report(GLU_INVALID_VALUE);
    return;
  }
  const Sphere sphere(*quadric, radius, std::min(slices, max_segment_count),
                      std::min(stacks, max_segment_count));
  switch (quadric->draw_style) {
    case GLU_FILL: sphere.fill(); break;
    case GLU_POINT: sphere.points(); break;
    default:
      // A sphere has no edge that GLU_SILHOUETTE could leave out.
      sphere.lines();
      break;
  }
}
