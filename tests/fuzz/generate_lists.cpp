// Display lists and attribute stacks.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void make_list(Builder& b) {
  // Mesa records errors of GL_COMPILE_AND_EXECUTE twice: lists have none.
  b.call("NewList", b.lists_made + 1,
         b.random.pick({"GL_COMPILE", "GL_COMPILE", "GL_COMPILE_AND_EXECUTE"}));
  b.in_list = true;
  const int steps = b.random.between(1, 5);
  for (int i = 0; i < steps; ++i) {
    const int choice = b.random.below(10);
    if (choice < 3) change_state(b);
    else if (choice < 5 && b.lists_made > 0) b.call("CallList", b.random.between(1, b.lists_made));
    else draw(b);
  }
  b.in_list = false;
  b.call("EndList");
  ++b.lists_made;
}

}  // namespace

void use_list(Builder& b) {
  auto& random = b.random;
  if (b.in_list || b.in_stack) return;
  if (b.lists_made < 4 && (b.lists_made == 0 || random.chance(50))) make_list(b);
  if (random.chance(70)) {
    b.call("CallList", random.between(1, b.lists_made));
  } else {
    b.call("ListBase", 1);
    b.call("CallLists", 3, "GL_UNSIGNED_BYTE",
           input("GLubyte", random.whole(3, 0, b.lists_made - 1)));
    b.call("ListBase", 0);
  }
  // Mesa keeps bitmaps back and draws them in the state that comes later.
  if (b.traits.pixels) b.call("Flush");
}

void use_stack(Builder& b) {
  if (b.in_stack) return;
  // Mesa's nested stacks lose changes.
  b.in_stack = true;
  const bool matrix = b.random.chance(40);
  if (matrix) b.call("PushMatrix");
  else
    b.call("PushAttrib",
           b.random.pick({"GL_ALL_ATTRIB_BITS", "GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT",
                          "GL_POLYGON_BIT | GL_LINE_BIT", "GL_CURRENT_BIT", "GL_TRANSFORM_BIT",
                          "GL_TEXTURE_BIT", "GL_SCISSOR_BIT | GL_VIEWPORT_BIT"}));
  const int steps = b.random.between(1, 4);
  for (int i = 0; i < steps; ++i) {
    if (b.random.chance(50)) {
      if (matrix) change_transform(b);
      else change_state(b);
    } else {
      draw_primitive(b);
    }
  }
  b.call(matrix ? "PopMatrix" : "PopAttrib");
  b.in_stack = false;
}

}  // namespace legacy_gl::fuzz
