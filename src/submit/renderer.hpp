#pragma once
#include "record/renderer.hpp"

namespace legacy_gl {

/// Draws over the driver of the context that it is given.
class DriverRenderer final : public Renderer {
 public:
  void draw_batch(legacy_gl_context& context) override;
  void draw_bitmaps(legacy_gl_context& context) override;
  void draw_mesh(legacy_gl_context& context, const ListMesh& mesh) override;
  bool detach_from_matrices(legacy_gl_context& context) override;
  bool shade_batch(legacy_gl_context& context) override;
  bool shades_next_draw(legacy_gl_context& context) override;
  void recover(legacy_gl_context& context) noexcept override;
};

}  // namespace legacy_gl
