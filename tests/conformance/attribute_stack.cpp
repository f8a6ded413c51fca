// GL 2.1 spec 6.1.14: what glPushAttrib saves, glPopAttrib brings back. Each scene changes much
// between the two and then draws. GL_LIGHTING_BIT with lights and materials both changed inside is
// in departures.cpp.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void change_lights(const GlFunctions& gl) {
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(-1, -0.3F, 0.7F, 0));
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(0.2F, 0.9F, 0.4F));
  gl.Enable(GL_LIGHT1);
  gl.Lightfv(GL_LIGHT1, GL_AMBIENT, vec(0.5F, 0, 0));
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.9F, 0.1F, 0.9F));
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
}

void change_current(const GlFunctions& gl) {
  gl.Color4f(0.9F, 0.6F, 0.1F, 0.5F);
  gl.Normal3f(0.6F, 0, 0.8F);
}

void change_enables(const GlFunctions& gl) {
  gl.Disable(GL_LIGHTING);
  gl.Enable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_LIGHT3);
}

void change_transform(const GlFunctions& gl) { gl.Enable(GL_NORMALIZE); }

void change_raster(const GlFunctions& gl) {
  gl.Viewport(10, 10, 50, 60);
  gl.DepthRange(0.3, 0.1);
  gl.Scissor(5, 5, 30, 30);
  gl.Enable(GL_SCISSOR_TEST);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.FrontFace(GL_CW);
  gl.CullFace(GL_FRONT);
  gl.LineWidth(3);
  gl.PointSize(7);
  gl.ShadeModel(GL_FLAT);
}

void change_buffers(const GlFunctions& gl) {
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_FALSE);
  gl.DepthFunc(GL_GREATER);
  gl.ClearColor(1, 0, 0, 1);
  gl.BlendFunc(GL_ONE, GL_ONE);
}

// Everything that the state changes above could spoil.
void draw_witnesses(const GlFunctions& gl) {
  draw_cube(gl, 0.45F);
  gl.PushMatrix();
  gl.Translatef(0.35F, 0.3F, 0);
  draw_sphere(gl, 0.5F);
  gl.PopMatrix();
  gl.Begin(GL_LINES);
  gl.Vertex3f(-1, -0.9F, 0.5F);
  gl.Vertex3f(0.9F, -0.6F, 0.5F);
  gl.End();
  gl.Disable(GL_LIGHTING);
  gl.Begin(GL_POINTS);
  gl.Vertex3f(-0.8F, 0.8F, 0.5F);
  gl.End();
}

// All of it is changed inside; what the mask leaves out stays changed, on purpose.
Scene pushed_scene(std::string name, GLbitfield mask, std::vector<Draw> changes) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Color4f(0.3F, 0.8F, 0.6F, 1);
            gl.PushAttrib(mask);
            for (const Draw& change : changes) change(gl);
            gl.PopAttrib();
            draw_witnesses(gl);
          }};
}

// Sixteen spheres with a material each: that of the level on the stack, or set just before.
void draw_levels(const GlFunctions& gl, bool stacked) {
  constexpr int levels = 16;
  const auto set_material = [&gl](int level) {
    const float f = static_cast<float>(level);
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.06F * f, 0.9F - 0.05F * f, 0.4F));
  };
  begin_lit_scene(gl);
  for (int i = 0; stacked && i < levels; ++i) {
    set_material(i);
    gl.PushAttrib(GL_LIGHTING_BIT | GL_CURRENT_BIT);
  }
  for (int i = levels - 1; i >= 0; --i) {
    if (stacked) gl.PopAttrib();
    else set_material(i);
    gl.PushMatrix();
    gl.Translatef(-0.75F + 0.5F * static_cast<float>(i % 4),
                  -0.75F + 0.5F * static_cast<float>(i / 4), 0);
    draw_sphere(gl, 0.2F, 8, 6);
    gl.PopMatrix();
  }
}

}  // namespace

std::vector<Scene> attribute_stack_scenes() {
  return {
      pushed_scene("current", GL_CURRENT_BIT, {change_current}),
      pushed_scene("current_leaves_the_rest", GL_CURRENT_BIT, {change_current, change_lights}),
      pushed_scene("enable", GL_ENABLE_BIT, {change_enables}),
      pushed_scene("lighting_lights", GL_LIGHTING_BIT, {change_lights}),
      pushed_scene("lighting_materials", GL_LIGHTING_BIT,
                   {[](const GlFunctions& gl) { use_brass(gl, GL_FRONT_AND_BACK); }}),
      pushed_scene("lighting_shade_model", GL_LIGHTING_BIT,
                   {[](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }}),
      pushed_scene("lighting_enables", GL_LIGHTING_BIT, {[](const GlFunctions& gl) {
                     gl.Disable(GL_LIGHTING);
                     gl.Disable(GL_LIGHT0);
                     gl.Enable(GL_LIGHT1);
                   }}),
      pushed_scene("lighting_color_material", GL_LIGHTING_BIT, {[](const GlFunctions& gl) {
                     gl.ColorMaterial(GL_FRONT, GL_EMISSION);
                     gl.Enable(GL_COLOR_MATERIAL);
                   }}),
      pushed_scene("transform", GL_TRANSFORM_BIT, {change_transform}),
      pushed_scene("viewport", GL_VIEWPORT_BIT, {[](const GlFunctions& gl) {
                     gl.Viewport(3, 4, 20, 30);
                     gl.DepthRange(1, 0);
                   }}),
      pushed_scene("polygon", GL_POLYGON_BIT, {[](const GlFunctions& gl) {
                     gl.Enable(GL_CULL_FACE);
                     gl.CullFace(GL_FRONT);
                     gl.FrontFace(GL_CW);
                     gl.PolygonMode(GL_FRONT, GL_POINT);
                   }}),
      pushed_scene("line_and_point", GL_LINE_BIT | GL_POINT_BIT, {[](const GlFunctions& gl) {
                     gl.LineWidth(5);
                     gl.PointSize(9);
                   }}),
      pushed_scene("scissor", GL_SCISSOR_BIT, {[](const GlFunctions& gl) {
                     gl.Scissor(20, 20, 10, 10);
                     gl.Enable(GL_SCISSOR_TEST);
                   }}),
      pushed_scene("depth_buffer", GL_DEPTH_BUFFER_BIT, {[](const GlFunctions& gl) {
                     gl.Disable(GL_DEPTH_TEST);
                     gl.DepthFunc(GL_ALWAYS);
                     gl.DepthMask(GL_FALSE);
                   }}),
      pushed_scene("color_buffer", GL_COLOR_BUFFER_BIT, {[](const GlFunctions& gl) {
                     gl.Enable(GL_BLEND);
                     gl.BlendFunc(GL_ZERO, GL_ONE);
                     gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
                   }}),
      pushed_scene("raster_groups",
                   GL_VIEWPORT_BIT | GL_SCISSOR_BIT | GL_POLYGON_BIT | GL_LINE_BIT | GL_POINT_BIT |
                       GL_LIGHTING_BIT,
                   {change_raster}),
      pushed_scene("all_groups", GL_ALL_ATTRIB_BITS,
                   {change_current, change_lights, change_enables, change_raster, change_buffers}),
      pushed_scene("nothing_pushed", 0, {change_lights, change_current}),
      // Mesa brings the materials back only where lights did not change, nor other groups were
      // pushed.
      {"nested_sixteen_deep",
       [](const GlFunctions& gl) { draw_levels(gl, true); },
       {.mesa_departure = "M9",
        .reference = [](const GlFunctions& gl) { draw_levels(gl, false); }}},
      {"drawn_inside_and_after",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.PushAttrib(GL_ALL_ATTRIB_BITS);
         change_lights(gl);
         gl.ShadeModel(GL_FLAT);
         in_quarter(gl, 0, 0, draw_witnesses);
         gl.PopAttrib();
         in_quarter(gl, 1, 1, draw_witnesses);
       }},
      {"matrix_mode_is_restored",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.PushAttrib(GL_TRANSFORM_BIT);
         gl.MatrixMode(GL_TEXTURE);
         gl.PopAttrib();
         gl.Rotatef(40, 1, 1, 0);
         draw_cube(gl, 0.5F);
         draw_torus(gl);
       }},
      // Light positions are kept in eye coordinates: the modelview at the pop is of no account.
      {"popped_under_another_modelview",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.PushAttrib(GL_LIGHTING_BIT);
         gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0, -1, 0, 0));
         gl.Rotatef(90, 0, 0, 1);
         gl.PopAttrib();
         draw_sphere(gl);
       }},
      {"client_arrays",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         const Mesh mesh = sphere_mesh();
         gl.EnableClientState(GL_VERTEX_ARRAY);
         gl.EnableClientState(GL_NORMAL_ARRAY);
         gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), mesh.vertices[0].position.data());
         gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), mesh.vertices[0].normal.data());
         gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
         gl.DisableClientState(GL_NORMAL_ARRAY);
         gl.VertexPointer(2, GL_SHORT, 0, nullptr);
         gl.EnableClientState(GL_COLOR_ARRAY);
         gl.PopClientAttrib();
         gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangle_indices.size()),
                         GL_UNSIGNED_SHORT, mesh.triangle_indices.data());
         gl.DisableClientState(GL_VERTEX_ARRAY);
         gl.DisableClientState(GL_NORMAL_ARRAY);
       }},
  };
}

}  // namespace legacy_gl::test
