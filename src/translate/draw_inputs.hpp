#pragma once
// From GL's state to what a draw needs: the program key and the values of the uniform blocks. No GL
// call.
#include <bitset>
#include <vector>

#include "context/context.hpp"
#include "geometry/vertex_layout.hpp"
#include "matrix/lighting_space.hpp"
#include "shadergen/program_key.hpp"
#include "shadergen/uniform_blocks.hpp"
#include "translate/light_culling.hpp"

namespace legacy_gl {

/// One face's block: the head, then the products of each light that is left.
struct FaceUniforms {
  MaterialUniforms head;
  std::vector<LightProducts> products;
};

/// An enabled light that adds something, and how its colours enter.
struct ActiveLight {
  unsigned index = 0;     ///< GL_LIGHT0 + index
  std::uint8_t kind = 0;  ///< LightKindBit
  double strength = 1;    ///< constant attenuation and the cone of a directional light
  bool black = false;     ///< fills its run up to a power of two
};

/// The matrix that takes normals to eye coordinates, as GL_NORMALIZE and GL_RESCALE_NORMAL ask for
/// it.
glm::dmat3 normal_matrix(const Context& context, const LinearPart& linear);

/// Which fragments primitives of this mode have. It depends on the mode, so that DrawInputs::key
/// has none of it.
Coverage coverage_of(const RasterState& raster, GLenum mode);

/// What is known of all vertices of a draw.
struct DrawFacts {
  const DrawBounds* bounds = nullptr;  ///< lights that do not reach them are left out
  bool unit_normals = false;           ///< need not be normalised where the modelview keeps angles
};

class DrawInputs {
 public:
  /// Brings key and values up to date with the state, as far as the dirty bits (which it clears,
  /// but for kDirtyRaster) and the batch's layout ask for. Sets `stale` for each block whose values
  /// changed.
  /// What is known of the draw's vertices spares work.
  void update(Context& context, const VertexLayout& layout, const DrawFacts& facts = {});

  /// Brings `general` up to date: from the values of the other blocks, which are filled.
  void fill_general(const Context& context);

  ProgramKey key;
  TransformUniforms transform;
  std::vector<LightUniforms> lights;
  std::array<FaceUniforms, 2> faces;
  PreciseUniforms precise;  ///< this and lights_low only in the precise quality
  std::vector<LightLow> lights_low;
  GeneralUniforms general;  ///< after fill_general
  FragmentUniforms fragments;
  ClipPlaneUniforms clip_planes;
  PointUniforms points;
  PolygonStippleUniforms polygon_stipple;
  TexturesUniforms textures;
  std::vector<TextureUnitUniforms> texture_units;
  std::array<bool, kUniformBlockCount> stale = all_stale();

 private:
  static std::array<bool, kUniformBlockCount> all_stale() {
    std::array<bool, kUniformBlockCount> all{};
    all.fill(true);
    return all;
  }
  void choose_fragments(const Context& context, const VertexLayout& layout);
  void fill_fragments(const Context& context);
  const Matrix& modelview(const Context& context) const;
  void update_transform(Context& context);
  void choose_space(const Context& context, const VertexLayout& layout);
  void choose_materials(const Context& context, const VertexLayout& layout);
  bool bakes(unsigned shininess);
  /// Components of light times material.
  struct LargestProducts {
    double any = 0, specular = 0;
  };
  void choose_lights(Context& context);
  void choose_terms(Context& context, const Light& light, ActiveLight active,
                    LargestProducts& largest);
  bool build_light_runs();
  void choose_sum_scale(const LightingState& lighting, double largest);
  void choose_specular(const Context& context, double largest_specular);
  bool choose_reached(Context& context, const VertexLayout& layout, const DrawBounds* bounds);
  bool choose_normalize(Context& context, bool unit_normals);
  void fill_up_runs();
  void fill_lighting(const Context& context, std::uint32_t dirty, const ProgramKey& before,
                     double length_before, bool before_only);
  void update_textures(Context& context, std::uint32_t dirty, bool layout_changed);
  void choose_textures(Context& context);
  void fill_textures(Context& context);
  void fill_transform(const Context& context);
  void find_eye_directions(const Context& context);
  /// From eye coordinates to the space that lights, normals and positions meet in.
  struct LightAxes {
    glm::dmat3 rotation{1.0};   ///< of points and axes
    glm::dmat3 covariant{1.0};  ///< of vectors that meet normals
    glm::dvec3 origin{0};
    double scale = 1;
  };
  LightAxes light_axes(const Context& context) const;
  void fill_direction(unsigned index, const LightAxes& axes, LightUniforms& uniforms,
                      LightLow& low_part) const;
  static void fill_point(const Light& light, const LightAxes& axes, LightUniforms& uniforms,
                         LightLow& low_part);
  static void fill_spot(const Light& light, const LightAxes& axes, LightUniforms& uniforms,
                        LightLow& low_part);
  void fill_lights(const Context& context);
  void fill_faces(const Context& context);

  /// The batch's vertices are in clip coordinates and eye coordinates already.
  bool transformed_ = false;
  LinearPart linear_;
  bool affine_ = true;
  bool parallel_ = false;  ///< clip coordinates have the w of object coordinates
  bool linear_known_ = false;
  double normal_length_ = 1;  ///< of a unit normal after the modelview, where the products take it
  bool normalizes_ = false;   ///< GL_NORMALIZE, and some normal is no unit vector
  bool directions_only_ = false;  ///< lights meet the normals as they are given
  double sum_scale_ = 1;          ///< what the products were divided by (scaled_sums)
  VertexLayout layout_;
  /// Unit vectors of each directional light in eye coordinates, for a viewer at infinity.
  struct EyeDirections {
    glm::dvec3 to_light, half_vector;
  };
  std::vector<EyeDirections> eye_directions_;
  std::vector<ActiveLight> active_;
  std::vector<ActiveLight> filled_up_;
  LightMask reached_ = LightMask().set();
  std::bitset<129> baked_shininess_;  ///< the values that programs have in their text
};

}  // namespace legacy_gl
