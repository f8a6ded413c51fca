// One function for each file of scenes; registry.cpp lists them.
#pragma once

#include <vector>

#include "conformance/scene.hpp"

namespace legacy_gl::test {

std::vector<Scene> lighting_rows_scenes();
std::vector<Scene> lights_scenes();
std::vector<Scene> materials_scenes();
std::vector<Scene> color_material_scenes();
std::vector<Scene> two_side_scenes();
std::vector<Scene> spot_scenes();
std::vector<Scene> attenuation_scenes();
std::vector<Scene> light_model_scenes();
std::vector<Scene> normals_scenes();
std::vector<Scene> matrices_scenes();
std::vector<Scene> primitives_scenes();
std::vector<Scene> shade_model_scenes();
std::vector<Scene> lists_scenes();
std::vector<Scene> arrays_scenes();
std::vector<Scene> attribute_stack_scenes();
std::vector<Scene> depth_blend_cull_scenes();
std::vector<Scene> points_lines_scenes();
std::vector<Scene> polygon_mode_scenes();
std::vector<Scene> polygon_stipple_scenes();
std::vector<Scene> line_stipple_scenes();
std::vector<Scene> material_in_begin_end_scenes();
std::vector<Scene> vertex_formats_scenes();
std::vector<Scene> rect_scenes();
std::vector<Scene> fog_scenes();
std::vector<Scene> alpha_test_scenes();
std::vector<Scene> clip_planes_scenes();
std::vector<Scene> bitmap_scenes();
std::vector<Scene> texture_environments_scenes();
std::vector<Scene> texture_filters_scenes();
std::vector<Scene> texture_coordinates_scenes();
std::vector<Scene> pixels_scenes();
std::vector<Scene> departures_scenes();

}  // namespace legacy_gl::test
