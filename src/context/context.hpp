#pragma once
#include <legacy_gl/context.h>

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <unordered_set>

#include "context/attribute_stack.hpp"
#include "dlist/list_state.hpp"
#include "evaluator/evaluator.hpp"
#include "lighting/lighting_state.hpp"
#include "matrix/matrix_stack.hpp"
#include "record/recorder.hpp"
#include "state/accumulation.hpp"
#include "state/client_arrays.hpp"
#include "state/clip_planes.hpp"
#include "state/current.hpp"
#include "state/dirty.hpp"
#include "state/feedback.hpp"
#include "state/fog.hpp"
#include "state/pixel_state.hpp"
#include "state/raster.hpp"
#include "state/selection.hpp"
#include "texture/bitmap_image.hpp"
#include "texture/texture_state.hpp"

namespace legacy_gl {

class Backend;

/// GL 2.1 spec 2.11.2, 2.11.3, table 6.8: the transform group.
struct TransformState {
  GLenum matrix_mode = GL_MODELVIEW;
  bool normalize_enabled = false;
  bool rescale_normal_enabled = false;
  ClipPlanes clip;
  MatrixStack modelview{32};
  MatrixStack projection{32};
  std::vector<MatrixStack> texture = std::vector<MatrixStack>(kMaxTextureUnits, MatrixStack(10));
};

}  // namespace legacy_gl

/// All that one context remembers: GL's state by groups, what is recorded and not drawn yet, and
/// the driver's side.
struct legacy_gl_context {
  explicit legacy_gl_context(const legacy_gl_options& chosen);
  ~legacy_gl_context();

  legacy_gl_options options;
  GLenum error = GL_NO_ERROR;
  std::uint32_t dirty = legacy_gl::kDirtyAll;

  legacy_gl::CurrentValues current;
  legacy_gl::Recorder recorder;
  legacy_gl::LightingState lighting;
  legacy_gl::TransformState transform;
  legacy_gl::RasterState raster;
  legacy_gl::FogState fog;
  legacy_gl::AccumulationState accumulation;
  legacy_gl::TextureState texture;
  legacy_gl::HintState hints;
  legacy_gl::SelectionState selection;
  legacy_gl::FeedbackState feedback;
  legacy_gl::EvaluatorState evaluators;
  legacy_gl::PixelStore pack, unpack;
  legacy_gl::PixelState pixels;
  GLenum read_buffer = GL_FRONT;  ///< set when the framebuffer is known
  legacy_gl::ClientArrays arrays;
  legacy_gl::AttributeStacks attribute_stacks;
  legacy_gl::ListState lists;
  bool color_sum_enabled = false;
  legacy_gl::BitmapImage bitmap_scratch;  ///< of the call that is executed
  bool bitmaps_pending = false;           ///< the backend has bitmaps that are not drawn yet
  unsigned active_texture = 0;  ///< unit that glMatrixMode(GL_TEXTURE) and its like address
  unsigned client_active_texture = 0;

  legacy_gl_statistics statistics{};
  std::unordered_set<std::string> diagnostics_given;
  std::string renderer;    ///< what glGetString(GL_RENDERER) answers, once asked
  std::string extensions;  ///< the same of GL_EXTENSIONS
  std::unique_ptr<legacy_gl::Backend> backend;
  std::thread::id current_in{};  ///< the thread in which it is current; default: none
};

namespace legacy_gl {

using Context = ::legacy_gl_context;

/// The context of this thread; nullptr when none is current.
extern constinit thread_local Context* current_context;
/// The same while calls are executed at once; nullptr while a list is being compiled. One test of
/// it is all that a call passes on its way.
extern constinit thread_local Context* direct_context;

/// Brings direct_context up to date: after a list is begun or ended, and while one is played.
void update_direct_context();

/// The error that glGetError returns next: the first one sticks (GL 2.1 spec 2.5).
void raise_error(Context& context, GLenum error);

/// Says once for each message what a program asked for that this library does not do.
void diagnose(Context& context, const std::string& message);

/// Draws what is recorded, primitives or bitmaps; in selection it only hits, and in feedback it is
/// written. Every setter calls it before it stores a value that differs.
void draw_pending(Context& context);
/// The recorder is full: what it has is drawn, and more of the same state follows.
void draw_part_of_batch(Context& context);
inline void flush_pending(Context& context) {
  if (context.recorder.has_pending() || context.bitmaps_pending) draw_pending(context);
}

/// Before the modelview or the projection changes: what is recorded is drawn, or its vertices are
/// transformed so that others can join them.
void leave_matrices(Context& context);

/// Lights the recorded object, a small one, so that nothing that lights it matters any more. False
/// when the batch is to be drawn instead.
bool light_object(Context& context);

/// Before lights, the light model or a material change: what is recorded is lit or drawn.
void leave_lighting(Context& context);

/// The next object of a batch that is lit here can be lit so too.
bool stays_lit(Context& context);

/// The order of every setter: what was recorded under the old value is drawn, then the value is
/// stored and its dirty bits raised. Returns *changed*.
template <typename T, typename U>
bool assign(Context& context, T& stored, const U& value, std::uint32_t dirty_bits) {
  if (stored == value) return false;
  flush_pending(context);
  stored = value;
  context.dirty |= dirty_bits;
  return true;
}

/// The same for what lights vertices.
template <typename T, typename U>
bool assign_lighting(Context& context, T& stored, const U& value, std::uint32_t dirty_bits) {
  if (stored == value) return false;
  leave_lighting(context);
  stored = value;
  context.dirty |= dirty_bits;
  return true;
}

}  // namespace legacy_gl
