#pragma once
// What the draws of one context share on their way to the driver.
#include <memory>
#include <vector>

#include "context/context.hpp"
#include "driver/driver_objects.hpp"
#include "geometry/unfilled.hpp"
#include "state/dirty.hpp"
#include "state/raster_position.hpp"
#include "submit/accumulation_buffer.hpp"
#include "submit/fast_path.hpp"
#include "submit/uniforms.hpp"
#include "translate/draw_inputs.hpp"

namespace legacy_gl {

struct Submission {
  explicit Submission(const Driver& driver) : uniforms(driver) {}

  DrawInputs inputs;  ///< of the last draw
  DirtyReaders dirty;
  UniformUploader uniforms;
  bool general_program = false;  ///< the program in use reads the general block
  AccumulationBuffer accumulation;
  RasterTextureCoordinates bitmap_texture_coordinates =
      kInitialTextureCoordinates;       ///< of the bitmaps that wait, where they are textured
  std::unique_ptr<FastPath> fast_path;  ///< nullptr where it does not pay

  // Memory that draws use again, so that a steady frame allocates nothing.
  std::vector<std::uint32_t> indices, elements;
  std::vector<float> floats;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  ExpandedBatch expanded;
  std::vector<float> wide_vertices;
  std::vector<std::size_t> wide_ends;  ///< in wide_vertices, by group of the expanded batch
};

}  // namespace legacy_gl
