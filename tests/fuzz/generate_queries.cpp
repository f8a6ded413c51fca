// Selection, feedback, and what glGet answers.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void select(Builder& b) {
  b.call("SelectBuffer", 256, output("GLuint", 256));
  b.call("RenderMode", "GL_SELECT");
  b.call("InitNames");
  b.call("PushName", 7);
  const int count = b.random.between(1, 4);
  for (int i = 0; i < count; ++i) {
    if (b.random.chance(70)) b.call("LoadName", i + 10);
    if (b.random.chance(30)) b.call("PushName", b.random.below(100));
    if (b.random.chance(30)) change_transform(b);
    draw_primitive(b);
  }
  b.call("RenderMode", "GL_RENDER");
}

void feed_back(Builder& b) {
  // M20: texture coordinates while nothing is textured.
  b.call("FeedbackBuffer", 4096,
         b.random.pick({"GL_2D", "GL_3D", b.traits.textured ? "GL_2D" : "GL_3D_COLOR"}),
         output("GLfloat", 4096));
  b.call("RenderMode", "GL_FEEDBACK");
  const int count = b.random.between(1, 3);
  for (int i = 0; i < count; ++i) {
    if (b.random.chance(40)) b.call("PassThrough", i + 1);
    if (b.random.chance(30)) change_transform(b);
    draw_primitive(b);
  }
  b.call("RenderMode", "GL_RENDER");
}

struct Question {
  const char* name;
  std::size_t count;
};

// Integers of matrices and of colours differ (M16).
constexpr std::array float_questions = {Question{"GL_CURRENT_COLOR", 4},
                                        Question{"GL_CURRENT_NORMAL", 3},
                                        Question{"GL_MODELVIEW_MATRIX", 16},
                                        Question{"GL_PROJECTION_MATRIX", 16},
                                        Question{"GL_TEXTURE_MATRIX", 16},
                                        Question{"GL_FOG_COLOR", 4},
                                        Question{"GL_LIGHT_MODEL_AMBIENT", 4},
                                        Question{"GL_DEPTH_RANGE", 2},
                                        Question{"GL_LINE_WIDTH", 1},
                                        Question{"GL_POINT_SIZE", 1},
                                        Question{"GL_COLOR_CLEAR_VALUE", 4},
                                        Question{"GL_ALPHA_TEST_REF", 1},
                                        Question{"GL_POLYGON_OFFSET_FACTOR", 1},
                                        Question{"GL_BLEND_COLOR", 4}};
constexpr std::array integer_questions = {Question{"GL_MATRIX_MODE", 1},
                                          Question{"GL_MODELVIEW_STACK_DEPTH", 1},
                                          Question{"GL_ATTRIB_STACK_DEPTH", 1},
                                          Question{"GL_POLYGON_MODE", 2},
                                          Question{"GL_BLEND_SRC", 1},
                                          Question{"GL_BLEND_DST_ALPHA", 1},
                                          Question{"GL_DEPTH_FUNC", 1},
                                          Question{"GL_STENCIL_REF", 1},
                                          Question{"GL_SCISSOR_BOX", 4},
                                          Question{"GL_VIEWPORT", 4},
                                          Question{"GL_SHADE_MODEL", 1},
                                          Question{"GL_FOG_MODE", 1},
                                          Question{"GL_LIST_BASE", 1},
                                          Question{"GL_LIST_INDEX", 1},
                                          Question{"GL_LINE_STIPPLE_PATTERN", 1},
                                          Question{"GL_COLOR_WRITEMASK", 4},
                                          Question{"GL_TEXTURE_BINDING_2D", 1},
                                          Question{"GL_ACTIVE_TEXTURE", 1},
                                          Question{"GL_RENDER_MODE", 1},
                                          Question{"GL_LOGIC_OP_MODE", 1}};

template <std::size_t n>
const Question& pick(Builder& b, const std::array<Question, n>& questions) {
  return questions[static_cast<std::size_t>(b.random.below(static_cast<int>(n)))];
}

void ask_of_raster_position(Builder& b) {
  b.call("RasterPos3f", b.coordinate(), b.coordinate(), b.random.real(-0.5, 0.5));
  // What an invalid position holds is undefined.
  b.call("GetBooleanv", "GL_CURRENT_RASTER_POSITION_VALID", output("GLboolean", 1));
  if (!b.traits.outside && !b.traits.clip_planes)
    b.call("GetFloatv", "GL_CURRENT_RASTER_POSITION", output("GLfloat", 4));
}

void ask_of_object(Builder& b) {
  auto& random = b.random;
  switch (random.below(6)) {
    case 0:
      return b.call("GetLightfv", random.pick({"GL_LIGHT0", "GL_LIGHT1", "GL_LIGHT7"}),
                    random.pick({"GL_AMBIENT", "GL_DIFFUSE", "GL_POSITION", "GL_SPECULAR"}),
                    output("GLfloat", 4));
    case 1:
      // M5: materials that are tracked.
      if (!b.traits.color_material)
        b.call("GetMaterialfv", random.pick({"GL_FRONT", "GL_BACK"}),
               random.pick({"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR", "GL_EMISSION"}),
               output("GLfloat", 4));
      return;
    case 2:
      return b.call("GetClipPlane", random.pick({"GL_CLIP_PLANE0", "GL_CLIP_PLANE1"}),
                    output("GLdouble", 4));
    case 3:
      return b.call("GetTexEnvfv", "GL_TEXTURE_ENV", "GL_TEXTURE_ENV_COLOR", output("GLfloat", 4));
    case 4:
      return b.call("GetTexEnviv", "GL_TEXTURE_ENV", "GL_TEXTURE_ENV_MODE", output("GLint", 1));
    default: return b.call("GetTexGenfv", "GL_S", "GL_OBJECT_PLANE", output("GLfloat", 4));
  }
}

}  // namespace

void use_hits(Builder& b) {
  if (b.in_list || b.in_stack) return;
  if (b.random.chance(50)) select(b);
  else feed_back(b);
}

void query(Builder& b) {
  if (b.in_list) return;
  switch (b.random.below(8)) {
    case 0:
    case 1: {
      const Question& question = pick(b, float_questions);
      return b.call("GetFloatv", question.name, output("GLfloat", question.count));
    }
    case 2:
    case 3: {
      const Question& question = pick(b, integer_questions);
      return b.call("GetIntegerv", question.name, output("GLint", question.count));
    }
    case 4: return ask_of_object(b);
    case 5:
      return b.call("IsEnabled", b.random.pick({"GL_LIGHTING", "GL_BLEND", "GL_FOG",
                                                "GL_TEXTURE_2D", "GL_LIGHT0", "GL_CULL_FACE",
                                                "GL_NORMALIZE", "GL_SCISSOR_TEST"}));
    case 6: return ask_of_raster_position(b);
    default:
      return b.call("ReadPixels", b.random.below(60), b.random.below(60), 4, 3, "GL_RGBA",
                    "GL_UNSIGNED_BYTE", output("GLubyte", 48));
  }
}

}  // namespace legacy_gl::fuzz
