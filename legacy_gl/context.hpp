/// C++ over <legacy_gl/context.h>: a context that destroys itself, and a failure that carries its
/// words.
#ifndef LEGACY_GL_CONTEXT_HPP
#define LEGACY_GL_CONTEXT_HPP

#include <legacy_gl/context.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace legacy_gl {

/// Thrown by Context's constructor and by make_current.
class Error : public std::runtime_error {
 public:
  explicit Error(legacy_gl_status status)
      : std::runtime_error(std::string(legacy_gl_status_string(status)) + ": " +
                           legacy_gl_status_detail()),
        status_(status) {}
  legacy_gl_status status() const noexcept { return status_; }

 private:
  legacy_gl_status status_;
};

/// Owns a legacy_gl_context. Destroy it while the driver context it was made over is current.
class OwnedContext {
 public:
  explicit OwnedContext(legacy_gl_loader loader, const legacy_gl_options& options = {}) {
    legacy_gl_status status = LEGACY_GL_OK;
    handle_.reset(legacy_gl_create_context(loader, &options, &status));
    if (!handle_) throw Error(status);
  }

  void make_current() {
    const legacy_gl_status status = legacy_gl_make_current(handle_.get());
    if (status != LEGACY_GL_OK) throw Error(status);
  }

  legacy_gl_context* get() const noexcept { return handle_.get(); }

 private:
  struct Destroy {
    void operator()(legacy_gl_context* context) const noexcept {
      legacy_gl_destroy_context(context);
    }
  };
  std::unique_ptr<legacy_gl_context, Destroy> handle_;
};

}  // namespace legacy_gl

#endif
