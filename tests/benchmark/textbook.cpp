#include "benchmark/textbook.hpp"

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

namespace legacy_gl::test {

namespace {

using oracle::State;

constexpr const char* kVertexShader = R"(
struct Light {
  vec4 position;
  vec3 ambient, diffuse, specular;
  vec3 spot_direction;
  float spot_exponent, spot_cos_cutoff;
  float constant_attenuation, linear_attenuation, quadratic_attenuation;
};
struct Material {
  vec4 ambient, diffuse, specular, emission;
  float shininess;
};
uniform mat4 modelview, modelview_projection;
uniform mat3 normal_matrix;
uniform bool normalize_normals, local_viewer, two_side, separate_specular;
uniform vec3 scene_ambient;
uniform Light lights[LIGHTS + 1];
uniform Material front_material, back_material;
uniform int tracked;

layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
flat out vec4 front_color, back_color;

vec4 lit(Material m, vec3 n, vec3 p) {
  if (tracked == 0 || tracked == 1) m.ambient = color;
  if (tracked == 0 || tracked == 2) m.diffuse = color;
  if (tracked == 3) m.specular = color;
  if (tracked == 4) m.emission = color;
  vec3 sum = m.emission.rgb + m.ambient.rgb * scene_ambient;
  vec3 specular_sum = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 l;
    float attenuation = 1.0;
    if (lights[i].position.w == 0.0) {
      l = normalize(lights[i].position.xyz);
    } else {
      l = lights[i].position.xyz / lights[i].position.w - p;
      float d = length(l);
      l = normalize(l);
      attenuation = 1.0 / (lights[i].constant_attenuation + lights[i].linear_attenuation * d +
                           lights[i].quadratic_attenuation * d * d);
    }
    if (lights[i].spot_cos_cutoff > -1.0) {
      float spot = dot(-l, normalize(lights[i].spot_direction));
      attenuation *= spot < lights[i].spot_cos_cutoff ? 0.0 : pow(max(spot, 0.0), lights[i].spot_exponent);
    }
    float n_dot_l = max(dot(n, l), 0.0);
    vec3 e = local_viewer ? normalize(-p) : vec3(0.0, 0.0, 1.0);
    vec3 h = normalize(l + e);
    float shine = n_dot_l > 0.0 ? pow(max(dot(n, h), 0.0), m.shininess) : 0.0;
    sum += attenuation * (m.ambient.rgb * lights[i].ambient + n_dot_l * m.diffuse.rgb * lights[i].diffuse);
    specular_sum += attenuation * shine * m.specular.rgb * lights[i].specular;
  }
  if (separate_specular)
    return vec4(clamp(sum, 0.0, 1.0) + clamp(specular_sum, 0.0, 1.0), m.diffuse.a);
  return clamp(vec4(sum + specular_sum, m.diffuse.a), 0.0, 1.0);
}

void main() {
  gl_Position = modelview_projection * position;
  vec3 p = (modelview * position).xyz;
  vec3 n = normal_matrix * normal;
  if (normalize_normals) n = normalize(n);
  front_color = lit(front_material, n, p);
  back_color = two_side ? lit(back_material, -n, p) : front_color;
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
flat in vec4 front_color, back_color;
layout(location = 0) out vec4 fragment_color;
void main() {
  fragment_color = gl_FrontFacing ? front_color : back_color;
}
)";

template <class Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(CoreContext::driver_proc(name));
  if (!function) throw std::runtime_error(std::string("the driver has no ") + name);
}

}  // namespace

// The core profile's own functions, beside the library.
struct Textbook::Functions {
  GLuint (*CreateShader)(GLenum);
  void (*ShaderSource)(GLuint, GLsizei, const char* const*, const GLint*);
  void (*CompileShader)(GLuint);
  void (*GetShaderiv)(GLuint, GLenum, GLint*);
  GLuint (*CreateProgram)();
  void (*AttachShader)(GLuint, GLuint);
  void (*LinkProgram)(GLuint);
  void (*GetProgramiv)(GLuint, GLenum, GLint*);
  void (*UseProgram)(GLuint);
  GLint (*GetUniformLocation)(GLuint, const char*);
  void (*Uniform1i)(GLint, GLint);
  void (*Uniform1f)(GLint, GLfloat);
  void (*Uniform3fv)(GLint, GLsizei, const GLfloat*);
  void (*Uniform4fv)(GLint, GLsizei, const GLfloat*);
  void (*UniformMatrix3fv)(GLint, GLsizei, GLboolean, const GLfloat*);
  void (*UniformMatrix4fv)(GLint, GLsizei, GLboolean, const GLfloat*);
  void (*GenVertexArrays)(GLsizei, GLuint*);
  void (*BindVertexArray)(GLuint);
  void (*GenBuffers)(GLsizei, GLuint*);
  void (*BindBuffer)(GLenum, GLuint);
  void (*BufferData)(GLenum, std::ptrdiff_t, const void*, GLenum);
  void (*EnableVertexAttribArray)(GLuint);
  void (*VertexAttribPointer)(GLuint, GLint, GLenum, GLboolean, GLsizei, const void*);
  void (*DrawArrays)(GLenum, GLint, GLsizei);
  void (*Enable)(GLenum);
  void (*Viewport)(GLint, GLint, GLsizei, GLsizei);
  void (*ClearColor)(GLfloat, GLfloat, GLfloat, GLfloat);
  void (*Clear)(GLbitfield);
  void (*PointSize)(GLfloat);
  void (*Finish)();
  GLuint current = 0;

  GLint at(const std::string& name) const { return GetUniformLocation(current, name.c_str()); }
  void set(const std::string& name, bool value) const { Uniform1i(at(name), value ? 1 : 0); }
  void set(const std::string& name, float value) const { Uniform1f(at(name), value); }
  void set3(const std::string& name, const float* v) const { Uniform3fv(at(name), 1, v); }
  void set4(const std::string& name, const float* v) const { Uniform4fv(at(name), 1, v); }
};

Textbook::Textbook(int width, int height)
    : context_(width, height, PixelFormat::rgba32f), gl_(std::make_unique<Functions>()) {
  Functions& f = *gl_;
  load(f.CreateShader, "glCreateShader");
  load(f.ShaderSource, "glShaderSource");
  load(f.CompileShader, "glCompileShader");
  load(f.GetShaderiv, "glGetShaderiv");
  load(f.CreateProgram, "glCreateProgram");
  load(f.AttachShader, "glAttachShader");
  load(f.LinkProgram, "glLinkProgram");
  load(f.GetProgramiv, "glGetProgramiv");
  load(f.UseProgram, "glUseProgram");
  load(f.GetUniformLocation, "glGetUniformLocation");
  load(f.Uniform1i, "glUniform1i");
  load(f.Uniform1f, "glUniform1f");
  load(f.Uniform3fv, "glUniform3fv");
  load(f.Uniform4fv, "glUniform4fv");
  load(f.UniformMatrix3fv, "glUniformMatrix3fv");
  load(f.UniformMatrix4fv, "glUniformMatrix4fv");
  load(f.GenVertexArrays, "glGenVertexArrays");
  load(f.BindVertexArray, "glBindVertexArray");
  load(f.GenBuffers, "glGenBuffers");
  load(f.BindBuffer, "glBindBuffer");
  load(f.BufferData, "glBufferData");
  load(f.EnableVertexAttribArray, "glEnableVertexAttribArray");
  load(f.VertexAttribPointer, "glVertexAttribPointer");
  load(f.DrawArrays, "glDrawArrays");
  load(f.Enable, "glEnable");
  load(f.Viewport, "glViewport");
  load(f.ClearColor, "glClearColor");
  load(f.Clear, "glClear");
  load(f.PointSize, "glPointSize");
  load(f.Finish, "glFinish");
  GLuint array = 0, buffer = 0;
  f.GenVertexArrays(1, &array);
  f.BindVertexArray(array);
  f.GenBuffers(1, &buffer);
  f.BindBuffer(GL_ARRAY_BUFFER, buffer);
  constexpr auto stride = GLsizei(sizeof(oracle::Vertex));
  const auto attribute = [&](GLuint index, GLint size, std::size_t offset) {
    f.EnableVertexAttribArray(index);
    f.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 4, offsetof(oracle::Vertex, position_object));
  attribute(1, 3, offsetof(oracle::Vertex, normal_object));
  attribute(2, 4, offsetof(oracle::Vertex, color));
}

Textbook::~Textbook() = default;

void Textbook::make_current() { context_.make_current(); }

void Textbook::clear() {
  gl_->ClearColor(0, 0, 0, 0);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

void Textbook::viewport(int x, int y, int width, int height) { gl_->Viewport(x, y, width, height); }

void Textbook::point_size(float size) { gl_->PointSize(size); }

void Textbook::discard_fragments() {
  constexpr GLenum kRasterizerDiscard = 0x8C89;
  gl_->Enable(kRasterizerDiscard);
}

void Textbook::finish() { gl_->Finish(); }

Image Textbook::read() { return context_.read_float(); }

GLuint Textbook::program(std::size_t light_count) {
  GLuint& name = programs_[light_count];
  if (name) return name;
  constexpr GLenum kFragment = 0x8B30, kVertex = 0x8B31, kCompiled = 0x8B81, kLinked = 0x8B82;
  name = gl_->CreateProgram();
  const std::string vertex =
      "#version 330 core\n#define LIGHTS " + std::to_string(light_count) + "\n" + kVertexShader;
  const std::pair<GLenum, const char*> stages[] = {{kVertex, vertex.c_str()},
                                                   {kFragment, kFragmentShader}};
  GLint good = 0;
  for (const auto& [stage, text] : stages) {
    const GLuint shader = gl_->CreateShader(stage);
    gl_->ShaderSource(shader, 1, &text, nullptr);
    gl_->CompileShader(shader);
    gl_->GetShaderiv(shader, kCompiled, &good);
    if (!good) throw std::runtime_error("the textbook's shader does not compile");
    gl_->AttachShader(name, shader);
  }
  gl_->LinkProgram(name);
  gl_->GetProgramiv(name, kLinked, &good);
  if (!good) throw std::runtime_error("the textbook's program does not link");
  return name;
}

void Textbook::set_state(const State& state, const oracle::Matrix4& modelview_projection) {
  Functions& f = *gl_;
  f.current = program(state.lights.size());
  f.UseProgram(f.current);
  const auto matrix = [](const oracle::Matrix4& m) { return glm::mat4(glm::make_mat4(m.data())); };
  const glm::mat4 modelview = matrix(state.modelview);
  const glm::mat4 placing = matrix(modelview_projection);
  glm::mat3 normal_matrix = glm::inverseTranspose(glm::mat3(modelview));
  if (state.rescale_normal) normal_matrix /= glm::length(normal_matrix[2]);
  f.UniformMatrix4fv(f.at("modelview"), 1, GL_FALSE, glm::value_ptr(modelview));
  f.UniformMatrix4fv(f.at("modelview_projection"), 1, GL_FALSE, glm::value_ptr(placing));
  f.UniformMatrix3fv(f.at("normal_matrix"), 1, GL_FALSE, glm::value_ptr(normal_matrix));
  f.set("normalize_normals", state.normalize);
  f.set("local_viewer", state.light_model.local_viewer);
  f.set("two_side", state.light_model.two_side);
  f.set("separate_specular", state.light_model.separate_specular_color);
  f.set3("scene_ambient", state.light_model.ambient.data());
  // All classes track both faces or none.
  f.Uniform1i(f.at("tracked"), state.color_material.enabled ? int(state.color_material.mode) : -1);
  const auto material = [&](const std::string& name, const oracle::Material& m) {
    f.set4(name + ".ambient", m.ambient.data());
    f.set4(name + ".diffuse", m.diffuse.data());
    f.set4(name + ".specular", m.specular.data());
    f.set4(name + ".emission", m.emission.data());
    f.set(name + ".shininess", m.shininess);
  };
  material("front_material", state.front);
  material("back_material", state.back);
  for (std::size_t i = 0; i < state.lights.size(); ++i) {
    const oracle::Light& light = state.lights[i];
    const std::string name = "lights[" + std::to_string(i) + "]";
    const glm::vec4 position =
        matrix(light.position_modelview) * glm::make_vec4(light.position_specified.data());
    const glm::vec3 direction = glm::mat3(matrix(light.spot_direction_modelview)) *
                                glm::make_vec3(light.spot_direction_specified.data());
    f.set4(name + ".position", glm::value_ptr(position));
    f.set3(name + ".ambient", light.ambient.data());
    f.set3(name + ".diffuse", light.diffuse.data());
    f.set3(name + ".specular", light.specular.data());
    f.set3(name + ".spot_direction", glm::value_ptr(direction));
    f.set(name + ".spot_exponent", light.spot_exponent);
    const float cutoff = light.spot_cutoff_degrees * std::numbers::pi_v<float> / 180;
    f.set(name + ".spot_cos_cutoff", light.spot_cutoff_degrees == 180 ? -1.0F : std::cos(cutoff));
    f.set(name + ".constant_attenuation", light.constant_attenuation);
    f.set(name + ".linear_attenuation", light.linear_attenuation);
    f.set(name + ".quadratic_attenuation", light.quadratic_attenuation);
  }
}

void Textbook::upload(std::span<const oracle::Vertex> vertices) {
  gl_->BufferData(GL_ARRAY_BUFFER, std::ptrdiff_t(vertices.size_bytes()), vertices.data(),
                  GL_STREAM_DRAW);
}

void Textbook::draw(GLenum mode, int count) { gl_->DrawArrays(mode, 0, count); }

}  // namespace legacy_gl::test
