// Texture images, parameters, environments, generated coordinates.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

constexpr int texture_size = 8;

// Texels that change gently: a coordinate in another last digit then gives nearly the same colour.
std::vector<double> texels(Builder& b, int count, int components) {
  std::vector<double> values;
  std::vector<double> value = b.random.whole(static_cast<std::size_t>(components), 60, 200);
  for (int i = 0; i < count; ++i)
    for (double& one : value) {
      one = std::min(255.0, std::max(30.0, one + b.random.between(-12, 12)));
      values.push_back(one);
    }
  return values;
}

void define_texture(Builder& b, const char* target, int texture) {
  auto& random = b.random;
  const bool plane = std::string_view(target) == "GL_TEXTURE_2D";
  const auto [format, components] =
      random.pick<std::pair<const char*, int>>({{"GL_RGBA", 4},
                                                {"GL_RGB", 3},
                                                {"GL_LUMINANCE", 1},
                                                {"GL_ALPHA", 1},
                                                {"GL_LUMINANCE_ALPHA", 2}});
  const char* internal =
      components == 1 && random.chance(20) && std::string_view(format) == "GL_LUMINANCE"
          ? "GL_INTENSITY"
          : format;
  b.call("BindTexture", target, texture);
  b.call("TexParameteri", target, "GL_TEXTURE_MIN_FILTER",
         random.pick({"GL_NEAREST", "GL_LINEAR"}));
  b.call("TexParameteri", target, "GL_TEXTURE_MAG_FILTER",
         random.pick({"GL_NEAREST", "GL_LINEAR"}));
  const Argument image =
      input("GLubyte", texels(b, texture_size * (plane ? texture_size : 1), components));
  if (plane)
    b.call("TexImage2D", target, 0, internal, texture_size, texture_size, 0, format,
           "GL_UNSIGNED_BYTE", image);
  else
    b.call("TexImage1D", target, 0, internal, texture_size, 0, format, "GL_UNSIGNED_BYTE", image);
}

void change_combiner(Builder& b) {
  auto& random = b.random;
  const auto env = [&](const char* parameter, const char* value) {
    b.call("TexEnvi", "GL_TEXTURE_ENV", parameter, value);
  };
  const auto source = [&] {
    return random.pick({"GL_TEXTURE", "GL_CONSTANT", "GL_PRIMARY_COLOR", "GL_PREVIOUS"});
  };
  env("GL_TEXTURE_ENV_MODE", "GL_COMBINE");
  env("GL_COMBINE_RGB",
      random.pick({"GL_REPLACE", "GL_MODULATE", "GL_ADD", "GL_ADD_SIGNED", "GL_INTERPOLATE",
                   "GL_SUBTRACT", "GL_DOT3_RGB", "GL_DOT3_RGBA"}));
  env("GL_COMBINE_ALPHA", random.pick({"GL_REPLACE", "GL_MODULATE", "GL_ADD", "GL_ADD_SIGNED",
                                       "GL_INTERPOLATE", "GL_SUBTRACT"}));
  for (const char* parameter : {"GL_SOURCE0_RGB", "GL_SOURCE1_RGB", "GL_SOURCE2_RGB",
                                "GL_SOURCE0_ALPHA", "GL_SOURCE1_ALPHA", "GL_SOURCE2_ALPHA"})
    if (random.chance(60)) env(parameter, source());
  for (const char* parameter : {"GL_OPERAND0_RGB", "GL_OPERAND1_RGB", "GL_OPERAND2_RGB"})
    if (random.chance(40))
      env(parameter, random.pick({"GL_SRC_COLOR", "GL_ONE_MINUS_SRC_COLOR", "GL_SRC_ALPHA",
                                  "GL_ONE_MINUS_SRC_ALPHA"}));
  if (random.chance(30))
    b.call("TexEnvf", "GL_TEXTURE_ENV", random.pick({"GL_RGB_SCALE", "GL_ALPHA_SCALE"}),
           random.pick({1, 2, 4}));
}

void change_generation(Builder& b) {
  auto& random = b.random;
  const char* coordinate = random.pick({"GL_S", "GL_T"});
  switch (random.below(4)) {
    case 0:
      b.call("TexGeni", coordinate, "GL_TEXTURE_GEN_MODE",
             random.pick({"GL_OBJECT_LINEAR", "GL_EYE_LINEAR", "GL_SPHERE_MAP"}));
      return;
    case 1:
      return b.call("TexGenfv", coordinate, random.pick({"GL_OBJECT_PLANE", "GL_EYE_PLANE"}),
                    floats(random.reals(4, -1, 1)));
    default:
      return b.enable(random.pick({"GL_TEXTURE_GEN_S", "GL_TEXTURE_GEN_T"}), random.chance(70));
  }
}

void change_texture_matrix(Builder& b) {
  b.call("MatrixMode", "GL_TEXTURE");
  if (b.random.chance(40)) b.call("LoadIdentity");
  else b.call("Rotatef", b.random.real(0, 360), 0, 0, 1);
  b.call("MatrixMode", "GL_MODELVIEW");
}

}  // namespace

void define_textures(Builder& b) {
  b.call("ActiveTexture", "GL_TEXTURE1");
  define_texture(b, "GL_TEXTURE_2D", 3);
  b.call("ActiveTexture", "GL_TEXTURE0");
  define_texture(b, "GL_TEXTURE_1D", 4);
  define_texture(b, "GL_TEXTURE_2D", 1);
  define_texture(b, "GL_TEXTURE_2D", 2);
  b.call("Enable", "GL_TEXTURE_2D");
}

void change_textures(Builder& b) {
  auto& random = b.random;
  if (random.chance(25))
    b.call("ActiveTexture", random.pick({"GL_TEXTURE0", "GL_TEXTURE0", "GL_TEXTURE1"}));
  switch (random.below(9)) {
    case 0: return b.call("BindTexture", "GL_TEXTURE_2D", random.pick({1, 2, 3}));
    case 1: return b.enable(random.pick({"GL_TEXTURE_2D", "GL_TEXTURE_1D"}), random.chance(70));
    case 2:
    case 3:
      return b.call("TexEnvi", "GL_TEXTURE_ENV", "GL_TEXTURE_ENV_MODE",
                    random.pick({"GL_MODULATE", "GL_REPLACE", "GL_DECAL", "GL_BLEND", "GL_ADD"}));
    case 4: return change_combiner(b);
    case 5: return b.call("TexEnvfv", "GL_TEXTURE_ENV", "GL_TEXTURE_ENV_COLOR", floats(b.color()));
    case 6:
      return b.call("TexParameteri", "GL_TEXTURE_2D",
                    random.pick({"GL_TEXTURE_WRAP_S", "GL_TEXTURE_WRAP_T"}),
                    random.pick({"GL_REPEAT", "GL_CLAMP_TO_EDGE", "GL_MIRRORED_REPEAT"}));
    case 7:
      if (b.traits.texgen) return change_generation(b);
      return change_texture_matrix(b);
    default:
      if (b.in_list) return;
      // All of a level, so that the texture stays complete.
      return b.call("TexSubImage2D", "GL_TEXTURE_2D", 0, 0, 0, 4, 4, "GL_RGBA", "GL_UNSIGNED_BYTE",
                    input("GLubyte", texels(b, 16, 4)));
  }
}

}  // namespace legacy_gl::fuzz
