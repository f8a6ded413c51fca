#include "fuzz/builder.hpp"

#include <cmath>

namespace legacy_gl::fuzz {

double Random::real(double low, double high) {
  const double unit = static_cast<double>(engine_() >> 11) / 9007199254740992.0;
  return std::round((low + (high - low) * unit) * 1000) / 1000;
}

std::vector<double> Random::reals(std::size_t count, double low, double high) {
  std::vector<double> values(count);
  for (double& value : values) value = real(low, high);
  return values;
}

std::vector<double> Random::whole(std::size_t count, int low, int high) {
  std::vector<double> values(count);
  for (double& value : values) value = between(low, high);
  return values;
}

Builder::Builder(std::uint64_t seed) : random(seed), traits(decide_traits(random)) {}

std::vector<double> Builder::color() {
  std::vector<double> result = random.reals(4, 0, 1);
  result[3] = random.real(0.2, 1);
  return result;
}

double Builder::coordinate() {
  if (traits.outside && random.chance(30)) return random.real(-2.5, 2.5);
  // D10: unfilled polygons are inside the view volume however they are turned.
  const double limit = traits.unfilled ? 0.6 : 0.9;
  return random.real(-limit, limit);
}

namespace {

void leave_out_for_unfilled(Traits& traits, Random& random) {
  // D10, D22: the edges that clipping adds. M19: stipple of the other face.
  traits.outside = traits.perspective = traits.clip_planes = traits.polygon_stipple = false;
  // D16: both share an attribute.
  traits.fog_coordinates = traits.evaluators = false;
  // D3: smooth edges.
  traits.smooth_lines = false;
  // M13: strips of lists are joined.
  if (random.chance(50)) traits.lists = false;
}

void leave_out_for_stipple(Traits& traits) {
  // D33: lines are cut before they are lit. Mesa interpolates stippled lines without perspective.
  traits.lit = traits.perspective = traits.fog = traits.vertex_w = traits.textured = false;
  // M22: strips of lists restart. M20: reset tokens.
  traits.lists = traits.hits = false;
}

void leave_out_for_pixels(Traits& traits) {
  // M17: bitmaps and pixel rectangles have no fog, no secondary colour, another texture coordinate;
  // lit raster positions are lit otherwise.
  traits.fog = traits.color_sum = traits.textured = traits.lit = traits.clip_planes = false;
}

}  // namespace

Traits decide_traits(Random& random) {
  Traits traits;
  for (bool Traits::*trait :
       {&Traits::lit, &Traits::fog, &Traits::textured, &Traits::unfilled, &Traits::line_stipple,
        &Traits::polygon_stipple, &Traits::wide, &Traits::blended, &Traits::clip_planes,
        &Traits::perspective, &Traits::outside, &Traits::pixels, &Traits::evaluators,
        &Traits::arrays, &Traits::lists, &Traits::stacks, &Traits::hits, &Traits::queries})
    traits.*trait = random.chance(25);
  traits.lit = traits.lit || random.chance(35);
  traits.arrays = traits.arrays || random.chance(20);
  for (bool Traits::*trait :
       {&Traits::smooth_lines, &Traits::logic_op, &Traits::flat, &Traits::errors,
        &Traits::color_sum, &Traits::vertex_w, &Traits::color_material, &Traits::two_sided,
        &Traits::spots, &Traits::fog_coordinates, &Traits::texgen})
    traits.*trait = random.chance(15);
  traits.color_components = random.chance(50) ? 3 : 4;

  if (traits.unfilled) leave_out_for_unfilled(traits, random);
  if (traits.line_stipple) leave_out_for_stipple(traits);
  if (traits.pixels) leave_out_for_pixels(traits);
  // M3: light directions leave w out.
  if (traits.lit) traits.vertex_w = false;
  // Mesa does not clamp the sum of the colours before fog.
  if (traits.fog) traits.color_sum = false;
  // M20: feedback's colours of flat shading; offsets; texture coordinates.
  if (traits.hits) traits.flat = traits.unfilled = false;
  // Evaluators change Mesa's current values.
  if (traits.evaluators) traits.color_material = traits.lists = false;
  traits.color_material = traits.color_material && traits.lit;
  traits.fog_coordinates = traits.fog_coordinates && traits.fog;
  return traits;
}

}  // namespace legacy_gl::fuzz
