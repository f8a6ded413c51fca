#pragma once

namespace legacy_gl {

struct ClientArrays {};

}  // namespace legacy_gl
