#include "glu_calls.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace glu_test {
namespace {

Calls recorded;

template <typename... Arguments>
void record(const char* name, Arguments... arguments) {
  recorded.push_back({name, {static_cast<double>(arguments)...}});
}

template <typename Scalar>
void record_matrix(const char* name, const Scalar* matrix) {
  recorded.push_back({name, {matrix, matrix + 16}});
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Call& call) {
  out << call.name << '(' << std::hexfloat;
  for (const double argument : call.arguments) {
    out << ' ' << argument;
  }
  return out << std::defaultfloat << " )";
}

Calls calls_of(const std::function<void()>& draw) {
  recorded.clear();
  draw();
  return recorded;
}

void expect_same(const Calls& ours, const Calls& theirs) {
  for (std::size_t i = 0; i < ours.size() && i < theirs.size(); ++i) {
    ASSERT_EQ(ours[i], theirs[i]) << "call " << i << " of " << ours.size();
  }
  ASSERT_EQ(ours.size(), theirs.size());
}

}  // namespace glu_test

using glu_test::record;
using glu_test::record_matrix;

extern "C" {
#define RECORD(name, parameters, ...)                        \
  void gl##name parameters { record(#name, ##__VA_ARGS__); } \
  void lgl##name parameters { record(#name, ##__VA_ARGS__); }

RECORD(Begin, (GLenum mode), mode)
RECORD(End, (), 0)
RECORD(Vertex3f, (GLfloat x, GLfloat y, GLfloat z), x, y, z)
RECORD(Normal3f, (GLfloat x, GLfloat y, GLfloat z), x, y, z)
RECORD(TexCoord2f, (GLfloat s, GLfloat t), s, t)
RECORD(Translated, (GLdouble x, GLdouble y, GLdouble z), x, y, z)
RECORD(Translatef, (GLfloat x, GLfloat y, GLfloat z), x, y, z)
RECORD(Scalef, (GLfloat x, GLfloat y, GLfloat z), x, y, z)
RECORD(Ortho, (GLdouble l, GLdouble r, GLdouble b, GLdouble t, GLdouble n, GLdouble f), l, r, b, t,
       n, f)
#undef RECORD

// libGLU draws a disk's points with glVertex2f; the z that the GL supplies is 0.
void glVertex2f(GLfloat x, GLfloat y) { record("Vertex3f", x, y, 0.0F); }

void glMultMatrixd(const GLdouble* matrix) { record_matrix("MultMatrixd", matrix); }
void lglMultMatrixd(const GLdouble* matrix) { record_matrix("MultMatrixd", matrix); }
void glMultMatrixf(const GLfloat* matrix) { record_matrix("MultMatrixf", matrix); }
void lglMultMatrixf(const GLfloat* matrix) { record_matrix("MultMatrixf", matrix); }
}
