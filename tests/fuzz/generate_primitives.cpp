// glBegin/glEnd with every attribute, and rectangles.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

struct Primitive {
  const char* mode;
  int least;
  int step;  // so that no vertices are left over: Mesa joins those to the next glBegin
  bool strip;
};

constexpr std::array primitives = {
    Primitive{"GL_POINTS", 1, 1, false},      Primitive{"GL_LINES", 2, 2, false},
    Primitive{"GL_LINE_STRIP", 2, 1, true},   Primitive{"GL_LINE_LOOP", 3, 1, true},
    Primitive{"GL_TRIANGLES", 3, 3, false},   Primitive{"GL_TRIANGLE_STRIP", 3, 1, true},
    Primitive{"GL_TRIANGLE_FAN", 3, 1, true}, Primitive{"GL_QUADS", 4, 4, false},
    Primitive{"GL_QUAD_STRIP", 4, 2, true},   Primitive{"GL_POLYGON", 3, 1, false}};

bool clipped(const Traits& traits) { return traits.outside || traits.clip_planes; }

const Primitive& pick_primitive(Builder& b) {
  while (true) {
    const Primitive& primitive =
        primitives[static_cast<std::size_t>(b.random.below(static_cast<int>(primitives.size())))];
    // M13, M22: strips of lists are joined or restarted where they are lines.
    if (primitive.strip && b.in_list && (b.traits.unfilled || b.traits.line_stipple)) continue;
    // Which diagonal Mesa cuts a quad along depends on whether anything else in its draw is
    // clipped.
    if (clipped(b.traits) && std::string_view(primitive.mode).starts_with("GL_QUAD")) continue;
    return primitive;
  }
}

// The first has the most components: Mesa splits primitives whose positions get more mid-way.
void vertex(Builder& b, const Position& position, bool first, bool four, bool plane) {
  const auto [x, y, z] = position;
  if (four)
    return b.call("Vertex4f", x, y, z, b.traits.vertex_w && !plane ? b.random.real(0.9, 1.5) : 1);
  switch (b.random.below(first || plane ? 3 : 4)) {
    case 0: return b.call("Vertex3f", x, y, z);
    case 1: return b.call("Vertex3d", x, y, z);
    case 2: return b.call("Vertex3fv", floats({x, y, z}));
    default: return b.call("Vertex2f", x, y);
  }
}

}  // namespace

std::vector<std::string> vertex_attributes(Builder& b) {
  std::vector<std::string> attributes;
  const auto maybe = [&](int percent, const std::string& attribute) {
    if (b.random.chance(percent)) attributes.push_back(attribute);
  };
  const bool alpha = b.traits.color_components == 4;
  // M15: programs have glColor3 or glColor4.
  maybe(b.traits.lit && !b.traits.color_material ? 20 : 75,
        alpha ? b.random.pick({"Color4f", "Color4ub", "Color4d", "Color4fv"})
              : b.random.pick({"Color3f", "Color3ub", "Color3fv", "Color3us"}));
  if (b.traits.lit || b.traits.texgen)
    maybe(80, b.random.pick({"Normal3f", "Normal3fv", "Normal3b", "Normal3s"}));
  if (b.traits.textured) {
    maybe(80, b.random.pick({"TexCoord2f", "TexCoord2fv", "TexCoord4f"}));
    maybe(40, "MultiTexCoord2f");
  }
  if (b.traits.color_sum) maybe(60, b.random.pick({"SecondaryColor3f", "SecondaryColor3ub"}));
  if (b.traits.fog_coordinates) maybe(70, "FogCoordf");
  // M9: materials do not come back with lights.
  if (b.traits.lit && !b.traits.color_material && !b.in_stack) maybe(15, "Material");
  return attributes;
}

void set_attribute(Builder& b, const std::string& attribute) {
  auto& random = b.random;
  const auto color = b.color();
  const auto byte = [&] { return random.below(256); };
  if (attribute == "Color3f") return b.call(attribute, color[0], color[1], color[2]);
  if (attribute == "Color3fv") return b.call(attribute, floats({color[0], color[1], color[2]}));
  if (attribute == "Color3ub") return b.call(attribute, byte(), byte(), byte());
  if (attribute == "Color3us")
    return b.call(attribute, random.below(65536), random.below(65536), 0);
  if (attribute == "Color4ub")
    return b.call(attribute, byte(), byte(), byte(), random.between(64, 255));
  if (attribute == "Color4fv") return b.call(attribute, floats(color));
  if (attribute.starts_with("Color4"))
    return b.call(attribute, color[0], color[1], color[2], color[3]);
  if (attribute == "SecondaryColor3f")
    return b.call(attribute, color[0] / 2, color[1] / 2, color[2] / 2);
  if (attribute == "SecondaryColor3ub")
    return b.call(attribute, byte() / 2, byte() / 2, byte() / 2);
  if (attribute == "FogCoordf") return b.call(attribute, random.real(0, 2));
  if (attribute == "TexCoord2f")
    return b.call(attribute, random.real(-0.5, 1.5), random.real(-0.5, 1.5));
  if (attribute == "TexCoord2fv") return b.call(attribute, floats(random.reals(2, 0, 1)));
  if (attribute == "TexCoord4f")
    return b.call(attribute, random.real(0, 1), random.real(0, 1), random.real(0, 1),
                  random.real(0.8, 1.2));
  if (attribute == "MultiTexCoord2f")
    return b.call(attribute, "GL_TEXTURE1", random.real(-0.5, 1.5), random.real(-0.5, 1.5));
  // The same property at each vertex: one that comes mid-way splits Mesa's primitives.
  if (attribute == "Material")
    return b.call("Materialfv", "GL_FRONT_AND_BACK", "GL_DIFFUSE", floats(color));
  // Normals towards the eye: zero vectors have no direction (D8).
  const auto x = random.real(-0.7, 0.7);
  const auto y = random.real(-0.7, 0.7);
  if (attribute == "Normal3f") return b.call(attribute, x, y, 0.7);
  if (attribute == "Normal3fv") return b.call(attribute, floats({x, y, 0.7}));
  if (attribute == "Normal3b")
    return b.call(attribute, random.between(-90, 90), random.between(-90, 90), 90);
  b.call("Normal3s", random.between(-20000, 20000), random.between(-20000, 20000), 22000);
}

void draw_primitive(Builder& b) {
  const Primitive& primitive = pick_primitive(b);
  const std::string_view mode = primitive.mode;
  const auto attributes = vertex_attributes(b);
  const bool flags =
      b.traits.unfilled && b.random.chance(30) && !primitive.strip && primitive.least > 2;
  const int count = primitive.least + primitive.step * b.random.below(b.random.chance(5) ? 60 : 5);
  const bool plane = mode.starts_with("GL_QUAD") || mode == "GL_POLYGON";
  const auto vertices = positions(b, mode, static_cast<std::size_t>(count));
  const bool four = b.random.chance(30);
  b.call("Begin", mode);
  for (const Position& position : vertices) {
    for (const std::string& attribute : attributes) set_attribute(b, attribute);
    // M12: of separate primitives alone.
    const bool first = &position == &vertices.front();
    if (flags) b.call("EdgeFlag", first ? 1 : b.random.below(2));
    vertex(b, position, first, four, plane);
  }
  b.call("End");
  if (flags) b.call("EdgeFlag", 1);
}

void draw_rectangle(Builder& b) {
  b.call(b.random.pick({"Rectf", "Rectd"}), b.coordinate(), b.coordinate(), b.coordinate(),
         b.coordinate());
}

}  // namespace legacy_gl::fuzz
