// GLU 1.3 specification 6.4, gluDisk and gluPartialDisk. Angle 0 is along +y, 90 degrees along +x;
// loop 0 is the outer rim.
#include <algorithm>

#include "glu/directions.hpp"
#include "glu/quadric.hpp"

namespace legacy_gl::glu {
namespace {

struct Sector {
  double start_degrees = 0.0;
  double sweep_degrees = 360.0;

  bool is_full() const { return sweep_degrees == 360.0; }
};

// A negative sweep goes the other way round, from the sector's end; more than a turn is one turn.
Sector normalised(double start_degrees, double sweep_degrees) {
  if (sweep_degrees < -360.0 || sweep_degrees > 360.0) {
    sweep_degrees = 360.0;
  }
  if (sweep_degrees < 0.0) {
    start_degrees += sweep_degrees;
    sweep_degrees = -sweep_degrees;
  }
  return {start_degrees, sweep_degrees};
}

Directions directions(const Sector& sector, int slices) {
  const float start_radians = static_cast<float>(sector.start_degrees / 180.0 * M_PI);
  Directions result(slices, static_cast<double>(start_radians), M_PI * sector.sweep_degrees / 180.0,
                    0.0);
  if (sector.is_full()) {
    result[slices] = result[0];
  }
  return result;
}

class Disk {
 public:
  Disk(const GLUquadric& quadric, double inner, double outer, int slices, int loops,
       const Sector& sector)
      : quadric_(quadric),
        inner_(inner),
        outer_(outer),
        slice_count_(slices),
        loop_count_(loops),
        // The last spoke of a full disk is the first.
        spoke_count_(sector.is_full() ? slices : slices + 1),
        slices_(directions(sector, slices)) {}

  void normal() const {
    if (quadric_.normals != GLU_NONE) {
      lglNormal3f(0.0F, 0.0F, quadric_.normal_sign());
    }
  }

  void fill() const {
    int band_count = loop_count_;
    if (inner_ == 0.0) {
      --band_count;
      fan(loop_count_ - 1);
    }
    for (int band = 0; band < band_count; ++band) {
      const int first = quadric_.inside() ? band + 1 : band;
      const int second = quadric_.inside() ? band : band + 1;
      lglBegin(GL_QUAD_STRIP);
      for (int slice = 0; slice <= slice_count_; ++slice) {
        vertex(slice, first);
        vertex(slice, second);
      }
      lglEnd();
    }
  }

  void lines() const {
    if (has_one_rim()) {
      single_rim();
      return;
    }
    for (int loop = 0; loop <= loop_count_; ++loop) {
      ring(loop);
    }
    for (int slice = 0; slice < spoke_count_; ++slice) {
      spoke(slice);
    }
  }

  void silhouette() const {
    if (spoke_count_ > slice_count_) {
      spoke(0);
      spoke(slice_count_);
    }
    ring(0);
    if (!has_one_rim()) {
      ring(loop_count_);
    }
  }

  void points() const {
    lglBegin(GL_POINTS);
    for (int slice = 0; slice < spoke_count_; ++slice) {
      for (int loop = 0; loop <= loop_count_; ++loop) {
        vertex(slice, loop);
      }
    }
    lglEnd();
  }

 private:
  bool has_one_rim() const { return inner_ == outer_; }

  void fan(int rim) const {
    lglBegin(GL_TRIANGLE_FAN);
    quadric_.texture_coordinate(0.5F, 0.5F);
    lglVertex3f(0.0F, 0.0F, 0.0F);
    for (int i = 0; i <= slice_count_; ++i) {
      vertex(quadric_.inside() ? i : slice_count_ - i, rim);
    }
    lglEnd();
  }

  // The one rim of a disk that is all hole, whose radius libGLU does not round to float.
  void single_rim() const {
    lglBegin(GL_LINE_STRIP);
    for (int slice = 0; slice <= slice_count_; ++slice) {
      const Direction& at = slices_[slice];
      quadric_.texture_coordinate(at.sine / 2.0F + 0.5F, at.cosine / 2.0F + 0.5F);
      lglVertex3f(static_cast<float>(outer_ * static_cast<double>(at.sine)),
                  static_cast<float>(outer_ * static_cast<double>(at.cosine)), 0.0F);
    }
    lglEnd();
  }

  void ring(int loop) const {
    lglBegin(GL_LINE_STRIP);
    for (int slice = 0; slice <= slice_count_; ++slice) {
      vertex(slice, loop);
    }
    lglEnd();
  }

  void spoke(int slice) const {
    lglBegin(GL_LINE_STRIP);
    for (int loop = 0; loop <= loop_count_; ++loop) {
      vertex(slice, loop);
    }
    lglEnd();
  }

  void vertex(int slice, int loop) const {
    const float fraction = static_cast<float>(loop) / static_cast<float>(loop_count_);
    const float decrease = static_cast<float>(outer_ - inner_);
    const float radius = static_cast<float>(outer_ - static_cast<double>(decrease * fraction));
    const Direction& at = slices_[slice];
    if (quadric_.has_texture) {
      const float half = static_cast<float>(static_cast<double>(radius) / outer_ / 2.0);
      quadric_.texture_coordinate(half * at.sine + 0.5F, half * at.cosine + 0.5F);
    }
    lglVertex3f(radius * at.sine, radius * at.cosine, 0.0F);
  }

  const GLUquadric& quadric_;
  double inner_;
  double outer_;
  int slice_count_;
  int loop_count_;
  int spoke_count_;
  Directions slices_;
};

}  // namespace
}  // namespace legacy_gl::glu

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluDisk(GLUquadric* quadric, GLdouble inner, GLdouble outer,
                                               GLint slices, GLint loops) {
  lgluPartialDisk(quadric, inner, outer, slices, loops, 0.0, 360.0);
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPartialDisk(GLUquadric* quadric, GLdouble inner,
                                                      GLdouble outer, GLint slices, GLint loops,
                                                      GLdouble start_degrees,
                                                      GLdouble sweep_degrees) {
  using namespace legacy_gl::glu;
  if (slices < 2 || loops < 1 || outer <= 0.0 || inner < 0.0 || inner > outer) {
    quadric->report(GLU_INVALID_VALUE);
    return;
  }
  const Disk disk(*quadric, inner, outer, std::min(slices, max_segment_count), loops,
                  normalised(start_degrees, sweep_degrees));
  disk.normal();
  switch (quadric->draw_style) {
    case GLU_FILL: disk.fill(); break;
    case GLU_LINE: disk.lines(); break;
    case GLU_SILHOUETTE: disk.silhouette(); break;
    default: disk.points(); break;
  }
}
