#pragma once
#include <legacy_gl/context.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <unordered_set>

#include "context/attribute_stack.hpp"
#include "context/optional_paths.hpp"
#include "evaluator/evaluator.hpp"
#include "lighting/lighting_state.hpp"
#include "matrix/matrix_stack.hpp"
#include "state/accumulation.hpp"
#include "state/client_arrays.hpp"
#include "state/clip_planes.hpp"
#include "state/current.hpp"
#include "state/dirty.hpp"
#include "state/feedback.hpp"
#include "state/fog.hpp"
#include "state/list_modes.hpp"
#include "state/pixel_state.hpp"
#include "state/raster.hpp"
#include "state/selection.hpp"
#include "texture/bitmap_image.hpp"
#include "texture/texture_state.hpp"

namespace legacy_gl {

class Recorder;
class Renderer;
struct DriverObjects;
struct ListState;
struct Submission;

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

/// All that one context remembers: GL's state by groups, and what works on it. The rooms above
/// know what that is; api/whole_context.hpp puts it together.
struct legacy_gl_context {
  legacy_gl_context(const legacy_gl_options& chosen, legacy_gl::Recorder& own_recorder,
                    legacy_gl::ListState& own_lists);
  virtual ~legacy_gl_context();
  legacy_gl_context(const legacy_gl_context&) = delete;
  legacy_gl_context& operator=(const legacy_gl_context&) = delete;

  legacy_gl_options options;
  legacy_gl::OptionalPaths paths;  ///< of LEGACY_GL_DISABLE
  GLenum error = GL_NO_ERROR;
  std::uint32_t dirty = legacy_gl::kDirtyAll;

  legacy_gl::CurrentValues current;
  legacy_gl::Recorder& recorder;
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
  legacy_gl::ListModes list_modes;
  legacy_gl::ListState& lists;
  bool color_sum_enabled = false;
  legacy_gl::BitmapImage bitmap_scratch;  ///< of the call that is executed
  bool bitmaps_pending = false;           ///< there are bitmaps that are not drawn yet
  unsigned active_texture = 0;  ///< unit that glMatrixMode(GL_TEXTURE) and its like address
  unsigned client_active_texture = 0;

  legacy_gl_statistics statistics{};
  std::unordered_set<std::string> diagnostics_given;
  std::string renderer_name;  ///< what glGetString(GL_RENDERER) answers, once asked
  std::string extensions;     ///< the same of GL_EXTENSIONS
  /// Who draws what is recorded; nullptr, as the next two: without a driver, in unit tests alone.
  legacy_gl::Renderer* renderer = nullptr;
  legacy_gl::DriverObjects* driver = nullptr;
  legacy_gl::Submission* submission = nullptr;
  std::atomic<std::thread::id> current_in{};  ///< where it is current; default: in no thread
};

namespace legacy_gl {

using Context = ::legacy_gl_context;

/// The context of this thread; nullptr when none is current.
extern constinit thread_local Context* current_context;
/// The error that glGetError returns next: the first one sticks (GL 2.1 spec 2.5).
void raise_error(Context& context, GLenum error);

/// Says once for each message what a program asked for that this library does not do.
void diagnose(Context& context, const std::string& message);

/// Says once that an entry point was called without a current context.
void report_no_context();

}  // namespace legacy_gl
