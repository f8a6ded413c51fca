#pragma once
#include <string>

namespace legacy_gl {

struct Driver;

/// What glGetString(GL_EXTENSIONS) answers: each name is a promise that its entry points work.
std::string extension_names(const Driver& driver);
bool driver_has_extension(const Driver& driver, const std::string& name);

}  // namespace legacy_gl
