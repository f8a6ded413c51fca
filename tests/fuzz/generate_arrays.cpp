// Client arrays and buffer objects.
#include "fuzz/generators.hpp"
#include "fuzz/validity.hpp"

namespace legacy_gl::fuzz {

namespace {

struct Mode {
  const char* name;
  int step;
};

struct Array {
  const char* pointer;
  const char* state;
  int components;
  const char* type;
  const char* element;
};

// Quads in groups of four, since each may be drawn as one.
std::vector<double> vertices(Builder& b, int components) {
  std::vector<double> values;
  for (const Position& position : positions(b, "GL_QUADS", array_vertices))
    for (int i = 0; i < components; ++i)
      values.push_back(i == 3 ? 1 : position[static_cast<std::size_t>(i)]);
  return values;
}

std::vector<double> elements(Builder& b, const Array& array) {
  const auto count = static_cast<std::size_t>(array.components * array_vertices);
  std::vector<double> values;
  const std::string_view pointer = array.pointer;
  const std::string_view element = array.element;
  if (pointer == "VertexPointer") return vertices(b, array.components);
  if (element == "GLubyte") return b.random.whole(count, 40, 255);
  // M14: no arrays of signed bytes.
  for (std::size_t i = 0; i < count; ++i) {
    if (pointer == "NormalPointer") values.push_back(i % 3 == 2 ? 0.7 : b.random.real(-0.7, 0.7));
    else values.push_back(b.random.real(pointer == "ColorPointer" ? 0.2 : 0, 1));
  }
  return values;
}

// Into a buffer object or as it is.
Argument place(Builder& b, const Array& array, bool buffer, int id) {
  const Argument data = input(array.element, elements(b, array));
  if (!buffer) return data;
  b.call("BindBuffer", "GL_ARRAY_BUFFER", id);
  b.call("BufferData", "GL_ARRAY_BUFFER", static_cast<int>(data.bytes.size()), data,
         "GL_STATIC_DRAW");
  return address(0);
}

void set_array(Builder& b, const Array& array, bool buffer, int id) {
  const Argument data = place(b, array, buffer, id);
  const std::string_view pointer = array.pointer;
  if (pointer == "NormalPointer" || pointer == "FogCoordPointer")
    b.call(pointer, array.type, 0, data);
  else b.call(pointer, array.components, array.type, 0, data);
  if (buffer) b.call("BindBuffer", "GL_ARRAY_BUFFER", 0);
  b.call("EnableClientState", array.state);
}

void set_arrays(Builder& b, bool buffers) {
  auto& random = b.random;
  const auto in_buffer = [&] { return buffers && random.chance(80); };
  const int components = random.between(2, 4);
  set_array(b, {"VertexPointer", "GL_VERTEX_ARRAY", components, "GL_FLOAT", "GLfloat"}, in_buffer(),
            1);
  if (random.chance(70)) {
    const bool bytes = random.chance(50);
    // M15: three components with glColor3 alone.
    set_array(b,
              {"ColorPointer", "GL_COLOR_ARRAY", b.traits.color_components,
               bytes ? "GL_UNSIGNED_BYTE" : "GL_FLOAT", bytes ? "GLubyte" : "GLfloat"},
              in_buffer(), 2);
  }
  if (b.traits.lit && random.chance(80))
    set_array(b, {"NormalPointer", "GL_NORMAL_ARRAY", 3, "GL_FLOAT", "GLfloat"}, in_buffer(), 3);
  if (b.traits.textured && random.chance(80))
    set_array(b, {"TexCoordPointer", "GL_TEXTURE_COORD_ARRAY", 2, "GL_FLOAT", "GLfloat"},
              in_buffer(), 4);
  if (b.traits.fog_coordinates && random.chance(60))
    set_array(b, {"FogCoordPointer", "GL_FOG_COORDINATE_ARRAY", 1, "GL_FLOAT", "GLfloat"},
              in_buffer(), 5);
  if (b.traits.color_sum && random.chance(60))
    set_array(b, {"SecondaryColorPointer", "GL_SECONDARY_COLOR_ARRAY", 3, "GL_FLOAT", "GLfloat"},
              in_buffer(), 6);
}

void interleaved(Builder& b) {
  const bool normals = b.traits.lit && b.random.chance(60);
  std::vector<double> values;
  for (const Position& position : positions(b, "GL_QUADS", array_vertices)) {
    if (normals)
      for (const double value : {b.random.real(-0.5, 0.5), b.random.real(-0.5, 0.5), 0.8})
        values.push_back(value);
    values.insert(values.end(), position.begin(), position.end());
  }
  b.call("InterleavedArrays", normals ? "GL_N3F_V3F" : "GL_V3F", 0, floats(values));
}

Argument indices(Builder& b, const Mode& mode, const char* element, int count, bool buffer) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const bool begins = mode.step != 4 || i % 4 == 0;
    values.push_back(!begins          ? values.back() + 1
                     : mode.step == 4 ? 4 * b.random.below(array_vertices / 4)
                                      : b.random.below(array_vertices));
  }
  const Argument data = input(element, values);
  if (!buffer) return data;
  b.call("BindBuffer", "GL_ELEMENT_ARRAY_BUFFER", 9);
  b.call("BufferData", "GL_ELEMENT_ARRAY_BUFFER", static_cast<int>(data.bytes.size()), data,
         "GL_STATIC_DRAW");
  return address(0);
}

void draw_indexed(Builder& b, const Mode& mode, int count, bool buffer) {
  auto& random = b.random;
  const auto [type, element] =
      random.pick<std::pair<const char*, const char*>>({{"GL_UNSIGNED_BYTE", "GLubyte"},
                                                        {"GL_UNSIGNED_SHORT", "GLushort"},
                                                        {"GL_UNSIGNED_INT", "GLuint"}});
  const Argument data = indices(b, mode, element, count, buffer);
  if (random.chance(50)) b.call("DrawElements", mode.name, count, type, data);
  else b.call("DrawRangeElements", mode.name, 0, array_vertices - 1, count, type, data);
  if (buffer) b.call("BindBuffer", "GL_ELEMENT_ARRAY_BUFFER", 0);
}

void draw_once(Builder& b, bool buffers) {
  auto& random = b.random;
  // Strips of lines restart in Mesa's lists (M13, M22); how a concave polygon is cut is undefined.
  const bool no_strips = b.in_list && (b.traits.unfilled || b.traits.line_stipple);
  const Mode mode =
      no_strips ? random.pick<Mode>({{"GL_TRIANGLES", 3}, {"GL_LINES", 2}, {"GL_POINTS", 1}})
      : b.traits.outside || b.traits.clip_planes
          // Which diagonal Mesa cuts a quad along depends on what else its draw clips.
          ? random.pick<Mode>({{"GL_TRIANGLES", 3}, {"GL_TRIANGLE_STRIP", 1}, {"GL_LINE_STRIP", 1}})
          : random.pick<Mode>({{"GL_POINTS", 1},
                               {"GL_LINES", 2},
                               {"GL_LINE_STRIP", 1},
                               {"GL_LINE_LOOP", 1},
                               {"GL_TRIANGLES", 3},
                               {"GL_TRIANGLE_STRIP", 1},
                               {"GL_TRIANGLE_FAN", 1},
                               {"GL_QUADS", 4}});
  const int count = mode.step * random.between(std::max(1, 4 / mode.step), 8 / mode.step);
  switch (random.below(4)) {
    case 0: return b.call("DrawArrays", mode.name, random.below(array_vertices - count + 1), count);
    case 1: return draw_indexed(b, mode, count, buffers && random.chance(50));
    case 2:
      if (mode.step == 1) return b.call("DrawArrays", mode.name, 0, count);
      return b.call("MultiDrawArrays", mode.name, input("GLint", {0, 4}),
                    input("GLint", {static_cast<double>(count), static_cast<double>(mode.step)}),
                    2);
    default:
      b.call("Begin", mode.name);
      for (int i = 0; i < count; ++i)
        b.call("ArrayElement", mode.step == 4 ? i : random.below(array_vertices));
      b.call("End");
  }
}

}  // namespace

void draw_arrays(Builder& b) {
  // Client state is not compiled: a list holds what the arrays held.
  b.call("PushClientAttrib", "GL_CLIENT_VERTEX_ARRAY_BIT");
  const bool buffers = b.random.chance(50);
  if (b.random.chance(15)) interleaved(b);
  else set_arrays(b, buffers);
  const int draws = b.random.between(1, 3);
  for (int i = 0; i < draws; ++i) {
    draw_once(b, buffers);
    if (i + 1 < draws && b.random.chance(30)) change_state(b);
  }
  b.call("PopClientAttrib");
  // Current values are undefined after arrays (2.8).
  const auto color = b.color();
  b.call(b.traits.color_components == 3 ? "Color3fv" : "Color4fv", floats(color));
  b.call("Normal3f", 0, 0, 1);
  b.call("TexCoord2f", color[0], color[1]);
  b.call("SecondaryColor3f", 0, 0, 0);
  b.call("FogCoordf", color[2]);
}

}  // namespace legacy_gl::fuzz
