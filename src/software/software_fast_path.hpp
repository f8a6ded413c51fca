#pragma once
#include <memory>

#include "submit/fast_path.hpp"
#include "submit/submission.hpp"

namespace legacy_gl {

/// A driver whose vertex shader and rasteriser are the CPU's: small draws are transformed or lit
/// here, so that draws of many matrices, lights and materials share one of the driver's.
/// docs/performance.md says what it is worth to programs.
class SoftwareFastPath final : public FastPath {
 public:
  bool detach_from_matrices(Context& context) override;
  bool shade_batch(Context& context) override;
  bool shades_next_draw(Context& context) override;
  bool append_mesh(Context& context, const ListMesh& mesh) override;
  bool finish_batch(Context& context) override;

 private:
  // transformed_draws.cpp
  bool can_transform(Context& context);
  bool begin_transformed(Context& context);
  void transform_vertices(Context& context);

  // shaded_draws.cpp
  struct PlacedMesh;
  static bool may_light(const Context& context);
  bool update_lighting(Context& context, const DrawFacts& facts);
  bool can_shade_mesh(Context& context, const ListMesh& mesh);
  void shade_vertices(Context& context);
  bool append_shaded_mesh(Context& context, const ListMesh& mesh);
  void append_front(Context& context, const ListMesh& mesh, const PlacedMesh& placed);
  void append_both_faces(Context& context, const ListMesh& mesh, const PlacedMesh& placed);

  DrawInputs lighting_;  ///< of what is lit here: submission.inputs draws it with an unlit program
  bool shades_affine_draws_ = false;  ///< the answer of shades_next_draw for usual materials
};

/// The fast path for this driver; nullptr where none pays.
std::unique_ptr<FastPath> make_software_fast_path(const Driver& driver);

}  // namespace legacy_gl
