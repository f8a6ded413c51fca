#pragma once
#include <optional>

#include "context/context.hpp"
#include "dlist/list_state.hpp"
#include "driver/driver_objects.hpp"
#include "record/recorder.hpp"
#include "submit/renderer.hpp"
#include "submit/submission.hpp"

namespace legacy_gl {

/// A context with all that works on it. Without a driver it records, and draws nothing.
class WholeContext final : public legacy_gl_context {
 public:
  explicit WholeContext(const legacy_gl_options& chosen)
      : legacy_gl_context(chosen, own_recorder_, own_lists_) {}

  ~WholeContext() override;

  /// Gives it the driver that is current.
  void attach(const Driver& functions, legacy_gl_programs programs, ProgramFiles files);

 private:
  Recorder own_recorder_;
  ListState own_lists_;
  std::optional<DriverObjects> objects_;
  std::optional<Submission> own_submission_;
  DriverRenderer own_renderer_;
};

}  // namespace legacy_gl
