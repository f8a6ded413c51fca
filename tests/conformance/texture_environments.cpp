// Texture environments (GL 2.1 spec 3.8.13, tables 3.22 to 3.25), filters and wraps (3.8.7, 3.8.8),
// images of every internal format.
#include "conformance/feature_scenes.hpp"
#include "conformance/texture_kit.hpp"

namespace legacy_gl::test {

namespace {

struct Named {
  const char* name;
  GLenum value;
};

constexpr Named kRgb{"rgb", GL_RGB}, kRgba{"rgba", GL_RGBA};
constexpr Named kBases[] = {{"alpha", GL_ALPHA},
                            {"luminance", GL_LUMINANCE},
                            {"la", GL_LUMINANCE_ALPHA},
                            {"intensity", GL_INTENSITY},
                            {"red", GL_RED},  // these two of ARB_texture_rg
                            {"rg", 0x8227},
                            kRgb,
                            kRgba};
constexpr Named kModes[] = {{"modulate", GL_MODULATE},
                            {"replace", GL_REPLACE},
                            {"decal", GL_DECAL},
                            {"blend", GL_BLEND},
                            {"add", GL_ADD}};

void set_environment(const GlFunctions& gl, GLenum mode) {
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, vec(0.9F, 0.2F, 0.4F, 0.6F));
}

void add_environments(std::vector<Scene>& scenes) {
  for (const Named& mode : kModes)
    for (const Named& base : kBases)
      scenes.push_back(
          {std::string("env_") + mode.name + "_" + base.name, [=](const GlFunctions& gl) {
             begin_flat_scene(gl);
             use_texture(gl, static_cast<GLint>(base.value), GL_NEAREST, GL_NEAREST);
             set_environment(gl, mode.value);
             draw_textured_quad(gl);
           }});
}

struct Combination {
  const char* name;
  GLenum function, sources[3], operands[3];
  GLint scale;
};

constexpr Combination kCombinations[] = {
    {"replace",
     GL_REPLACE,
     {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
     {GL_ONE_MINUS_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
     1},
    {"modulate",
     GL_MODULATE,
     {GL_TEXTURE, GL_PRIMARY_COLOR, GL_CONSTANT},
     {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
     2},
    {"add",
     GL_ADD,
     {GL_TEXTURE, GL_CONSTANT, GL_CONSTANT},
     {GL_SRC_COLOR, GL_SRC_ALPHA, GL_SRC_ALPHA},
     1},
    {"add_signed",
     GL_ADD_SIGNED,
     {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
     {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
     2},
    {"interpolate",
     GL_INTERPOLATE,
     {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
     {GL_SRC_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR},
     1},
    {"subtract",
     GL_SUBTRACT,
     {GL_PREVIOUS, GL_TEXTURE, GL_CONSTANT},
     {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
     4},
    {"dot3_rgb",
     GL_DOT3_RGB,
     {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
     {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
     1},
    {"dot3_rgba",
     GL_DOT3_RGBA,
     {GL_TEXTURE, GL_CONSTANT, GL_CONSTANT},
     {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA},
     2},
};

void set_combination(const GlFunctions& gl, const Combination& c) {
  set_environment(gl, GL_COMBINE);
  const auto set = [&](GLenum name, GLenum value) {
    gl.TexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value));
  };
  set(GL_COMBINE_RGB, c.function);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, c.scale);
  for (GLenum i = 0; i < 3; ++i) {
    set(GL_SRC0_RGB + i, c.sources[i]);
    set(GL_OPERAND0_RGB + i, c.operands[i]);
  }
  set(GL_COMBINE_ALPHA, GL_ADD);
  set(GL_SRC0_ALPHA, GL_TEXTURE);
  set(GL_SRC1_ALPHA, GL_PRIMARY_COLOR);
  set(GL_OPERAND1_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void add_combinations(std::vector<Scene>& scenes) {
  for (const Combination& combination : kCombinations)
    for (const Named& base : {kRgb, kRgba})
      scenes.push_back({std::string("combine_") + combination.name + "_" + base.name,
                        [=](const GlFunctions& gl) {
                          begin_flat_scene(gl);
                          use_texture(gl, static_cast<GLint>(base.value), GL_NEAREST, GL_NEAREST);
                          set_combination(gl, combination);
                          draw_textured_quad(gl);
                        },
                        {.few_colors = true}});
}

constexpr Named kFilters[] = {{"nearest", GL_NEAREST},
                              {"linear", GL_LINEAR},
                              {"nearest_mipmap_nearest", GL_NEAREST_MIPMAP_NEAREST},
                              {"linear_mipmap_nearest", GL_LINEAR_MIPMAP_NEAREST},
                              {"nearest_mipmap_linear", GL_NEAREST_MIPMAP_LINEAR},
                              {"linear_mipmap_linear", GL_LINEAR_MIPMAP_LINEAR}};
constexpr Named kWraps[] = {{"clamp", GL_CLAMP},
                            {"clamp_to_edge", GL_CLAMP_TO_EDGE},
                            {"clamp_to_border", GL_CLAMP_TO_BORDER},
                            {"repeat", GL_REPEAT},
                            {"mirrored_repeat", GL_MIRRORED_REPEAT}};

// A floor that runs away from the eye: near it the texture is magnified, far away minified.
void add_filters(std::vector<Scene>& scenes) {
  for (const Named& filter : kFilters)
    scenes.push_back({std::string("filter_") + filter.name,
                      [=](const GlFunctions& gl) {
                        begin_scene(gl);
                        use_texture(gl, GL_RGB, filter.value,
                                    filter.value == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
                        gl.Begin(GL_QUADS);
                        textured_vertex(gl, 0, 0, -1.5F, -1, 1.8F);
                        textured_vertex(gl, 3, 0, 1.5F, -1, 1.8F);
                        textured_vertex(gl, 3, 9, 1.5F, 0.6F, -5);
                        textured_vertex(gl, 0, 9, -1.5F, 0.6F, -5);
                        gl.End();
                      },
                      {.filtered = true}});
}

void add_wraps(std::vector<Scene>& scenes) {
  for (const Named& wrap : kWraps)
    for (const Named& filter : {kFilters[0], kFilters[1], kFilters[3]})
      for (const Named& base : {kBases[0], kBases[2], kBases[5]})
        scenes.push_back({std::string("wrap_") + wrap.name + "_" + filter.name + "_" + base.name,
                          [=](const GlFunctions& gl) {
                            begin_flat_scene(gl);
                            use_texture(gl, static_cast<GLint>(base.value), filter.value,
                                        filter.value == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
                            const auto mode = static_cast<GLint>(wrap.value);
                            gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
                            gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
                            gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR,
                                              vec(0.9F, 0.1F, 0.6F, 0.3F));
                            gl.Begin(GL_QUADS);
                            textured_vertex(gl, -0.9F, -1.2F, -0.9F, -0.9F);
                            textured_vertex(gl, 1.9F, -1.3F, 0.9F, -0.8F);
                            textured_vertex(gl, 2.1F, 2.3F, 0.9F, 0.9F);
                            textured_vertex(gl, -1.1F, 1.8F, -0.8F, 0.9F);
                            gl.End();
                          },
                          {.filtered = true}});
}

// Six formats that OpenGL ES has no storage for are held in 8 bits there: 12 and 16 bits.
constexpr Named kFormats[] = {{"1", 1},
                              {"2", 2},
                              {"3", 3},
                              {"4", 4},
                              {"alpha8", GL_ALPHA8},
                              {"luminance8", GL_LUMINANCE8},
                              {"luminance8_alpha8", GL_LUMINANCE8_ALPHA8},
                              {"intensity8", GL_INTENSITY8},
                              {"rgb8", GL_RGB8},
                              {"rgba8", GL_RGBA8},
                              {"r8", 0x8229},
                              {"rg8", 0x822B},
                              {"r16", 0x822A},
                              {"rg16", 0x822C},
                              {"alpha16", GL_ALPHA16},
                              {"luminance12", GL_LUMINANCE12},
                              {"luminance16_alpha16", GL_LUMINANCE16_ALPHA16},
                              {"intensity16", GL_INTENSITY16},
                              {"rgb16", GL_RGB16},
                              {"rgba16", GL_RGBA16}};

void add_formats(std::vector<Scene>& scenes) {
  for (const Named& format : kFormats)
    scenes.push_back({std::string("format_") + format.name,
                      [=](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        use_texture(gl, static_cast<GLint>(format.value), GL_NEAREST, GL_NEAREST);
                        draw_textured_quad(gl);
                      },
                      {.filtered = true}});
}

}  // namespace

std::vector<Scene> texture_environments_scenes() {
  std::vector<Scene> scenes;
  add_environments(scenes);
  add_combinations(scenes);
  add_formats(scenes);
  return scenes;
}

std::vector<Scene> texture_filters_scenes() {
  std::vector<Scene> scenes;
  add_filters(scenes);
  add_wraps(scenes);
  return scenes;
}

}  // namespace legacy_gl::test
