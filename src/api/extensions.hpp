#pragma once
#include <string>

namespace legacy_gl {

struct Driver;

/// What glGetString(GL_EXTENSIONS) answers: each name is a promise that its entry points work.
std::string extension_names(const Driver& driver);

}  // namespace legacy_gl
