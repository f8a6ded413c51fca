#pragma once
// KHR_debug: what apitrace and RenderDoc show of the driver's objects and calls. Nothing happens
// where the driver has it not, or nobody asked (Driver::ObjectLabel is nullptr then).
#include <string>

#include "driver/driver.hpp"

namespace legacy_gl {

/// Loads the functions where they are `wanted`, LEGACY_GL_DEBUG has "labels", or the driver's
/// context is a debug context.
void load_debug_labels(Driver& driver, Loader loader, bool wanted);

/// Names an object that was bound once. `kind` is GL_BUFFER, GL_TEXTURE, GL_PROGRAM, …
void label(const Driver& driver, GLenum kind, GLuint name, const std::string& text);

/// The driver's calls between the two stand in a group, under the call of OpenGL 1.x that led to
/// them.
void push_debug_group(const Driver& driver, const char* what);
void pop_debug_group(const Driver& driver);

}  // namespace legacy_gl
