#pragma once
// The contexts of the drop-in: which of the driver's carry one of ours, and what happens when a
// program makes one current or destroys it. GLX and EGL share this.
#include <legacy_gl/context.h>

#include <functional>

namespace legacy_gl::platform {

/// A GLXContext or an EGLContext.
using DriverContext = void*;

/// The driver is too old: said once, on stderr.
void report_old_driver();

/// The program asked for a legacy context, and `made` is the driver's core context in its place.
/// `share`: what the program shares with, or nullptr. `accumulation_buffer`: its configuration has
/// one.
void adopt(DriverContext made, DriverContext share, bool accumulation_buffer = false);

/// Makes `next` current by `make_current`, the driver's own call, and ours on top of it when it has
/// one. False, with nothing changed, when the driver refuses.
bool switch_to(DriverContext next, legacy_gl_loader loader,
               const std::function<bool()>& make_current);

/// Destroys what we hold for the context, now or, while it is current in a thread, when that thread
/// leaves it. `with_current` makes the context current without a surface, calls its argument and
/// restores what was current.
void forget(DriverContext context,
            const std::function<void(const std::function<void()>&)>& with_current);

}  // namespace legacy_gl::platform
