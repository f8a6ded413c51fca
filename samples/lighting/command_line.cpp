#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr int hidden = -1;

std::string text(const float* values, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += (i > 0 ? " " : "") + CLI::detail::to_string(values[i]);
  }
  return result;
}

// A word of the help for a value, in place of CLI11's list of what its number may be.
template <typename Value>
CLI::Validator choice(const std::map<std::string, Value>& names) {
  CLI::CheckedTransformer transformer(names);
  transformer.description("");
  return transformer;
}

void add_vector(CLI::App& app, const std::string& name, const char* components, float* destination,
                const std::string& description, const std::string& group) {
  app.add_option_function<std::vector<float>>(
         name,
         [destination](const std::vector<float>& values) {
           std::copy(values.begin(), values.end(), destination);
         },
         description)
      ->expected(3)
      ->type_name(components)
      ->default_str(text(destination, 3))
      ->group(group);
}

void add_flag(CLI::App& app, const std::string& name, int& destination,
              const std::string& description, const std::string& group) {
  app.add_flag_function(
         name, [&destination](std::int64_t count) { destination = count > 0 ? 1 : 0; }, description)
      ->group(group);
}

void add_light(CLI::App& app, const std::string& name, light& l) {
  const std::string group = "The " + name + " light";
  const std::string option = "--" + name;
  const bool directional = l.position[3] == 0.0F;
  add_flag(app, option + ",!--no-" + name, l.on, "Switch it on or off", group);
  add_vector(app, option + (directional ? "-towards" : "-position"), "X Y Z", l.position,
             directional ? "Direction towards the light" : "Where it stands", group);
  add_vector(app, option + "-ambient", "R G B", l.ambient, "Its own ambient light", group);
  add_vector(app, option + "-diffuse", "R G B", l.diffuse, "Its diffuse light", group);
  add_vector(app, option + "-specular", "R G B", l.specular, "Its highlights", group);
  if (!directional) {
    add_vector(app, option + "-attenuation", "K0 K1 K2", l.attenuation,
               "1 / (k0 + k1 d + k2 d^2) of the light reaches distance d", group);
  }
  if (l.spot_cutoff_degrees < 180.0F) {
    add_vector(app, option + "-direction", "X Y Z", l.spot_direction, "Where it points", group);
    app.add_option(option + "-cutoff", l.spot_cutoff_degrees,
                   "Half the angle of the cone in degrees; 180: no cone")
        ->check(CLI::Range(0.0F, 90.0F) | CLI::IsMember({180.0F}))
        ->type_name("DEGREES")
        ->group(group);
    app.add_option(option + "-exponent", l.spot_exponent, "How sharply it falls off")
        ->check(CLI::Range(0.0F, 128.0F))
        ->group(group);
  }
}

void add_shapes(CLI::App& app, settings& s) {
  const std::string group = "Shapes";
  std::map<std::string, int> names;
  for (int i = 0; i < MATERIAL_COUNT; ++i) {
    names[materials[i].name] = i;
  }
  app.add_option("--back-material", s.back_material,
                 "Material of the back faces: brass, turquoise, black-plastic")
      ->transform(choice(names))
      ->type_name("MATERIAL")
      ->default_str(materials[s.back_material].name)
      ->group(group);
  names["none"] = hidden;
  for (const auto& [name, shape] :
       {std::pair{"sphere", SHAPE_SPHERE}, {"cube", SHAPE_CUBE}, {"torus", SHAPE_TORUS}}) {
    int& index = s.shape_material[shape];
    app.add_option("--" + std::string(name), index,
                   "Its material: brass, turquoise, black-plastic, or none to leave it out")
        ->transform(choice(names))
        ->type_name("MATERIAL")
        ->default_str(materials[index].name)
        ->group(group);
  }
  app.add_option("--torus-sweep", s.torus_sweep_degrees,
                 "Degrees of the torus; less than 360 opens it, for --two-sided")
      ->check(CLI::Range(1.0F, 360.0F))
      ->group(group);
  app.add_option("--detail", s.detail, "Segments around a shape")
      ->check(CLI::Range(8, 1024))
      ->group(group);
  add_vector(app, "--emission", "R G B", s.emission, "Light that the shapes give off", group);
  app.add_option("--shininess", s.shininess, "Instead of each material's own")
      ->check(CLI::Range(0.0F, 128.0F))
      ->default_str("that of each material")
      ->group(group);
}

void add_light_model(CLI::App& app, settings& s) {
  const std::string group = "Light model";
  add_vector(app, "--global-ambient", "R G B", s.global_ambient, "Ambient light of no light",
             group);
  add_flag(app, "--local-viewer", s.local_viewer, "Highlights seen from the eye's true place",
           group);
  add_flag(app, "--two-sided", s.two_sided, "Light back faces with the back material", group);
  add_flag(app, "--separate-specular", s.separate_specular, "GL_SEPARATE_SPECULAR_COLOR", group);
  app.add_option("--interpolation", s.faceted, "One colour a facet, or colours between vertices")
      ->transform(choice(std::map<std::string, int>{{"faceted", 1}, {"gouraud", 0}}))
      ->type_name("faceted|gouraud")
      ->default_str("gouraud")
      ->group(group);
}

void add_pictures(CLI::App& app, CommandLine& line) {
  app.add_option("--output", line.output, "Directory for ours.png, mesa.png and difference.png");
  app.add_option_function<std::string>(
         "--size",
         [&s = line.scene](const std::string& size) {
           char separator = 0;
           std::istringstream in(size);
           if (!(in >> s.width >> separator >> s.height) || separator != 'x' || s.width < 1 ||
               s.height < 1 || s.width > 8192 || s.height > 8192 || !in.eof()) {
             throw CLI::ValidationError("--size", "WIDTHxHEIGHT, each from 1 to 8192");
           }
         },
         "Size of the pictures in pixels")
      ->type_name("WIDTHxHEIGHT")
      ->default_str("800x600");
  app.add_option("--dialect", line.dialect,
                 "What legacy_gl draws over: OpenGL 3.3 core by OSMesa, or OpenGL ES 3.0 by EGL")
      ->transform(
          choice(std::map<std::string, Dialect>{{"core", Dialect::core}, {"es", Dialect::es}}))
      ->type_name("core|es")
      ->default_str("core");
  app.add_option("--amplification", line.amplification,
                 "What difference.png multiplies the difference by")
      ->check(CLI::Range(1, 255));
}

}  // namespace

CommandLine parse_command_line(int argc, char** argv) {
  CommandLine line;
  CLI::App app(
      "Draws one OpenGL 1.x scene twice, by Mesa's own fixed function and by legacy_gl on core "
      "OpenGL or OpenGL ES, and compares the pictures.");
  app.get_formatter()->column_width(44);
  app.option_defaults()->always_capture_default();
  add_pictures(app, line);
  add_shapes(app, line.scene);
  add_light_model(app, line.scene);
  add_light(app, "directional", line.scene.lights[LIGHT_DIRECTIONAL]);
  add_light(app, "positional", line.scene.lights[LIGHT_POSITIONAL]);
  add_light(app, "spot", line.scene.lights[LIGHT_SPOT]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Prints the help or the message while the options still exist.
    std::exit(app.exit(error));
  }

  for (int shape = 0; shape < SHAPE_COUNT; ++shape) {
    line.scene.shape_shown[shape] = line.scene.shape_material[shape] == hidden ? 0 : 1;
  }
  return line;
}
