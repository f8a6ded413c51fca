// Each appends calls of its area to the program. What known deviations concern is left out where it
// would be made; comments cite the rows of docs/deviations.md.
#pragma once

#include "fuzz/builder.hpp"

namespace legacy_gl::fuzz {

// The program of a seed: always the same.
Program generate(std::uint64_t seed);

void set_initial_state(Builder& b);
void change_transform(Builder& b);
void change_state(Builder& b);
void draw(Builder& b);

void change_lighting(Builder& b);
void change_material(Builder& b);
void change_fog(Builder& b);

void define_textures(Builder& b);
void change_textures(Builder& b);

void change_rasterization(Builder& b);
void change_fragments(Builder& b);

void draw_primitive(Builder& b);
void draw_rectangle(Builder& b);
void draw_arrays(Builder& b);
void draw_evaluators(Builder& b);
void draw_pixels(Builder& b);

void use_list(Builder& b);
void use_stack(Builder& b);
void use_hits(Builder& b);
void query(Builder& b);
void raise_error(Builder& b);

using Position = std::array<double, 3>;
// For glBegin(mode); polygons have at most eight.
std::vector<Position> positions(Builder& b, std::string_view mode, std::size_t count);

// What a vertex is given besides its position.
std::vector<std::string> vertex_attributes(Builder& b);
void set_attribute(Builder& b, const std::string& attribute);

}  // namespace legacy_gl::fuzz
