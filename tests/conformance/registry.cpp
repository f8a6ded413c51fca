#include "conformance/feature_scenes.hpp"

namespace legacy_gl::test {

const std::vector<Feature>& features() {
  static const std::vector<Feature> all = {
      {"lighting_rows", lighting_rows_scenes()},
      {"lights", lights_scenes()},
      {"materials", materials_scenes()},
      {"color_material", color_material_scenes()},
      {"two_side", two_side_scenes()},
      {"spot", spot_scenes()},
      {"attenuation", attenuation_scenes()},
      {"light_model", light_model_scenes()},
      {"normals", normals_scenes()},
      {"matrices", matrices_scenes()},
      {"primitives", primitives_scenes()},
      {"shade_model", shade_model_scenes()},
      {"lists", lists_scenes()},
      {"arrays", arrays_scenes()},
      {"attribute_stack", attribute_stack_scenes()},
      {"depth_blend_cull", depth_blend_cull_scenes()},
      {"points_lines", points_lines_scenes()},
      {"polygon_mode", polygon_mode_scenes()},
      {"polygon_stipple", polygon_stipple_scenes()},
      {"line_stipple", line_stipple_scenes()},
      {"material_in_begin_end", material_in_begin_end_scenes()},
      {"vertex_formats", vertex_formats_scenes()},
      {"rect", rect_scenes()},
      {"fog", fog_scenes()},
      {"alpha_test", alpha_test_scenes()},
      {"clip_planes", clip_planes_scenes()},
      {"bitmap", bitmap_scenes()},
      {"texture_environments", texture_environments_scenes()},
      {"texture_filters", texture_filters_scenes()},
      {"texture_coordinates", texture_coordinates_scenes()},
      {"pixels", pixels_scenes()},
      {"departures", departures_scenes()},
  };
  return all;
}

}  // namespace legacy_gl::test
