#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "texture/texture_object.hpp"

namespace legacy_gl {

using TexturePointer = std::shared_ptr<TextureObject>;

/// The names and textures that contexts which share see alike. A texture that is deleted lives on
/// where another context has it bound (GL 2.1 spec D.3).
class TextureNames {
 public:
  /// Reserves `count` names; they become textures when they are bound first.
  void generate(GLsizei count, GLuint* names);
  /// nullptr for 0 and for names that were never bound.
  TexturePointer find(GLuint name) const;
  /// The texture of that name, which is made for `target` if there is none.
  TexturePointer find_or_create(GLuint name, TextureTarget target);
  void remove(GLuint name);

 private:
  mutable std::mutex mutex_;
  std::map<GLuint, TexturePointer> textures_;  ///< nullptr: reserved
};

}  // namespace legacy_gl
