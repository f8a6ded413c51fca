// User clip planes. On OpenGL ES fragments are discarded where OpenGL clips primitives (deviation
// D15): the edge then falls on the same pixels but for rounding, so the planes here run between
// pixel centres.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void clip(const GlFunctions& gl, GLenum plane, double a, double b, double c, double d) {
  const double equation[] = {a, b, c, d};
  gl.ClipPlane(plane, equation);
  gl.Enable(plane);
}

Scene clipped_square(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Disable(GL_DEPTH_TEST);
            set(gl);
            gl.Begin(GL_QUADS);
            gl.Color3f(1, 0, 0);
            gl.Vertex2f(-0.9F, -0.9F);
            gl.Color3f(0, 1, 0);
            gl.Vertex2f(0.9F, -0.9F);
            gl.Color3f(0, 0, 1);
            gl.Vertex2f(0.9F, 0.9F);
            gl.Color3f(1, 1, 0);
            gl.Vertex2f(-0.9F, 0.9F);
            gl.End();
          }};
}

}  // namespace

std::vector<Scene> clip_planes_scenes() {
  return {
      clipped_square("one_plane",
                     [](const GlFunctions& gl) { clip(gl, GL_CLIP_PLANE0, 1, 0, 0, 0.25); }),
      clipped_square("two_planes",
                     [](const GlFunctions& gl) {
                       clip(gl, GL_CLIP_PLANE0, 1, 0, 0, 0.5);
                       clip(gl, GL_CLIP_PLANE3, 0, -1, 0, 0.25);
                     }),
      clipped_square("six_planes",
                     [](const GlFunctions& gl) {
                       clip(gl, GL_CLIP_PLANE0, 1, 0, 0, 0.75);
                       clip(gl, GL_CLIP_PLANE1, -1, 0, 0, 0.75);
                       clip(gl, GL_CLIP_PLANE2, 0, 1, 0, 0.75);
                       clip(gl, GL_CLIP_PLANE3, 0, -1, 0, 0.5);
                       clip(gl, GL_CLIP_PLANE4, 0, 0, 1, 1);
                       clip(gl, GL_CLIP_PLANE5, 0, 0, -1, 1);
                     }),
      clipped_square("plane_takes_modelview_when_specified",
                     [](const GlFunctions& gl) {
                       gl.PushMatrix();
                       gl.Translatef(0.25F, 0, 0);
                       gl.Rotatef(90, 0, 0, 1);
                       clip(gl, GL_CLIP_PLANE0, 0, 1, 0, 0.25);
                       gl.PopMatrix();
                     }),
      clipped_square("disabled_again",
                     [](const GlFunctions& gl) {
                       clip(gl, GL_CLIP_PLANE0, 1, 0, 0, 0);
                       gl.Disable(GL_CLIP_PLANE0);
                     }),
      clipped_square("attribute_group",
                     [](const GlFunctions& gl) {
                       clip(gl, GL_CLIP_PLANE0, 1, 0, 0, 0.25);
                       gl.PushAttrib(GL_TRANSFORM_BIT);
                       clip(gl, GL_CLIP_PLANE0, -1, 0, 0, 0.25);
                       clip(gl, GL_CLIP_PLANE1, 0, 1, 0, 0);
                       gl.PopAttrib();
                     }),
  };
}

}  // namespace legacy_gl::test
