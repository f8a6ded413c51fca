#pragma once

namespace legacy_gl {

struct AttributeStacks {};

}  // namespace legacy_gl
