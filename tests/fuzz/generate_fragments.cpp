// Tests, blending, masks, logical operations, clears.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

const char* comparison(Builder& b) {
  return b.random.pick({"GL_NEVER", "GL_LESS", "GL_EQUAL", "GL_LEQUAL", "GL_GREATER", "GL_NOTEQUAL",
                        "GL_GEQUAL", "GL_ALWAYS", "GL_ALWAYS", "GL_LEQUAL"});
}

void change_blending(Builder& b) {
  auto& random = b.random;
  const auto factor = [&](bool source) {
    return random.pick({"GL_ZERO", "GL_ONE", "GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA",
                        "GL_DST_ALPHA", "GL_ONE_MINUS_DST_ALPHA",
                        source ? "GL_DST_COLOR" : "GL_SRC_COLOR", "GL_CONSTANT_COLOR",
                        "GL_ONE_MINUS_CONSTANT_ALPHA"});
  };
  switch (random.below(5)) {
    case 0: return b.enable("GL_BLEND", random.chance(80));
    case 1: return b.call("BlendFunc", factor(true), factor(false));
    case 2:
      return b.call("BlendFuncSeparate", factor(true), factor(false), factor(true), factor(false));
    case 3:
      return b.call("BlendEquation", random.pick({"GL_FUNC_ADD", "GL_FUNC_SUBTRACT",
                                                  "GL_FUNC_REVERSE_SUBTRACT", "GL_MIN", "GL_MAX"}));
    default: {
      const auto color = b.color();
      return b.call("BlendColor", color[0], color[1], color[2], color[3]);
    }
  }
}

void change_stencil(Builder& b) {
  auto& random = b.random;
  const auto operation = [&] {
    return random.pick({"GL_KEEP", "GL_ZERO", "GL_REPLACE", "GL_INCR", "GL_DECR", "GL_INVERT",
                        "GL_INCR_WRAP", "GL_DECR_WRAP"});
  };
  switch (random.below(4)) {
    case 0: return b.enable("GL_STENCIL_TEST", random.chance(70));
    case 1: return b.call("StencilFunc", comparison(b), random.below(4), random.pick({255, 3, 1}));
    case 2: return b.call("StencilMask", random.pick({255, 255, 3, 0}));
    default: return b.call("StencilOp", operation(), operation(), operation());
  }
}

void clear(Builder& b) {
  const auto color = b.color();
  switch (b.random.below(4)) {
    case 0: return b.call("ClearColor", color[0], color[1], color[2], color[3]);
    case 1: return b.call("ClearStencil", b.random.below(4));
    case 2: return b.call("ClearDepth", b.random.pick({1.0, 1.0, 0.5}));
    default:
      return b.call("Clear", b.random.pick({"GL_DEPTH_BUFFER_BIT", "GL_STENCIL_BUFFER_BIT",
                                            "GL_COLOR_BUFFER_BIT"}));
  }
}

}  // namespace

void change_fragments(Builder& b) {
  auto& random = b.random;
  switch (random.below(12)) {
    case 0: return b.enable("GL_DEPTH_TEST", random.chance(70));
    case 1: return b.call("DepthFunc", comparison(b));
    case 2: return b.call("DepthMask", random.below(2));
    case 3: return change_stencil(b);
    case 4: return b.enable("GL_ALPHA_TEST", random.chance(60));
    case 5: return b.call("AlphaFunc", comparison(b), random.real(0.1, 0.9));
    case 6: return b.enable("GL_SCISSOR_TEST", random.chance(40));
    case 7:
      return b.call("Scissor", random.below(20), random.below(20), random.between(10, 50),
                    random.between(10, 50));
    case 8:
      return b.call("ColorMask", random.chance(80) ? 1 : 0, random.chance(80) ? 1 : 0, 1,
                    random.chance(80) ? 1 : 0);
    case 9: return clear(b);
    case 10:
      if (!b.traits.logic_op) return b.call("DepthRange", random.real(0, 0.4), random.real(0.6, 1));
      if (random.chance(50)) return b.enable("GL_COLOR_LOGIC_OP", random.chance(70));
      return b.call("LogicOp", random.pick({"GL_COPY", "GL_XOR", "GL_AND", "GL_OR", "GL_INVERT",
                                            "GL_EQUIV", "GL_NOOP", "GL_OR_REVERSE", "GL_CLEAR"}));
    default:
      if (b.traits.blended) return change_blending(b);
      return b.enable("GL_DEPTH_TEST", random.chance(70));
  }
}

}  // namespace legacy_gl::fuzz
