#pragma once
#include <map>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// The unused names of one kind of object, kept as ranges: what a name costs does not grow with the
/// number of names in use. When memory runs out in a call, nothing has changed.
class FreeNames {
 public:
  /// The first of `count` unused names in a row; 0 when there are none. Small names come first, as
  /// programs expect, as far as that takes no search.
  GLuint find(GLuint count) const;
  /// From here on the names that find(count) answers are used. Allocates nothing.
  void take(GLuint first, GLuint count) noexcept;
  /// The application chose the name itself. 0 and used names are ignored.
  void use(GLuint name);
  /// Gives back names that are used, all of them.
  void release(GLuint first, GLuint count);

 private:
  std::map<GLuint, GLuint> ranges_{{1, 0xffffffffu}};  ///< first and last name; no two touch
};

}  // namespace legacy_gl
