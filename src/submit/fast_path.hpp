#pragma once
struct legacy_gl_context;

namespace legacy_gl {

struct ListMesh;

/// What may be done instead of a driver's work where the driver rasterises on the CPU
/// (src/software). Everything here may answer no, and where there is none all answers are no.
class FastPath {
 public:
  virtual ~FastPath() = default;

  /// As Renderer has them.
  virtual bool detach_from_matrices(legacy_gl_context& context) = 0;
  virtual bool shade_batch(legacy_gl_context& context) = 0;
  virtual bool shades_next_draw(legacy_gl_context& context) = 0;

  /// A small mesh joins the recorder's batch, its vertices transformed or lit.
  virtual bool append_mesh(legacy_gl_context& context, const ListMesh& mesh) = 0;
  /// Before the recorder's batch is drawn: transforms or lights what is left of a batch that has
  /// begun so. False for every other batch.
  virtual bool finish_batch(legacy_gl_context& context) = 0;
};

}  // namespace legacy_gl
