#pragma once
// What the recorder, and the calls that change state, ask of the rooms that draw.

struct legacy_gl_context;

namespace legacy_gl {

struct ListMesh;

/// submit/ implements it over a driver, a unit test by notes of what it was asked.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Draws the recorder's batch, which has primitives, and clears it. In selection the primitives
  /// hit, in feedback they are written.
  virtual void draw_batch(legacy_gl_context& context) = 0;
  virtual void draw_bitmaps(legacy_gl_context& context) = 0;
  /// Draws a display list's mesh in the present state.
  virtual void draw_mesh(legacy_gl_context& context, const ListMesh& mesh) = 0;

  /// The modelview or the projection is about to change: brings the batch into a form that does not
  /// read them any more. False when the batch is to be drawn instead.
  virtual bool detach_from_matrices(legacy_gl_context& context) = 0;
  /// The same of lights, the light model and materials: the batch's vertices are lit here.
  virtual bool shade_batch(legacy_gl_context& context) = 0;
  /// The next primitives can be lit here too, as a batch that shade_batch has lit goes on.
  virtual bool shades_next_draw(legacy_gl_context& context) = 0;

  /// An exception ended what was under way, wherever that was: forgets all that may be half done.
  virtual void recover(legacy_gl_context& context) noexcept = 0;
};

}  // namespace legacy_gl
