#pragma once

namespace legacy_gl {

/// The digest of the generator's sources, from the build. Programs and keys that another version
/// wrote are not readable.
const char* generator_version();

}  // namespace legacy_gl
