#include "texture/texture_names.hpp"

namespace legacy_gl {

void TextureNames::generate(GLsizei count, GLuint* names) {
  const std::lock_guard lock(mutex_);
  // Small numbers first, as programs expect: below the first gap, or behind the last.
  GLuint name = 1;
  for (GLsizei i = 0; i < count; ++i, ++name) {
    while (textures_.contains(name)) ++name;
    textures_.emplace(name, nullptr);
    names[i] = name;
  }
}

TexturePointer TextureNames::find(GLuint name) const {
  const std::lock_guard lock(mutex_);
  const auto at = textures_.find(name);
  return at == textures_.end() ? nullptr : at->second;
}

TexturePointer TextureNames::find_or_create(GLuint name, TextureTarget target) {
  const std::lock_guard lock(mutex_);
  TexturePointer& texture = textures_[name];
  if (!texture) texture = std::make_shared<TextureObject>(name, target);
  return texture;
}

void TextureNames::remove(GLuint name) {
  TexturePointer last;  // its destructor calls the driver: not under the lock
  const std::lock_guard lock(mutex_);
  const auto at = textures_.find(name);
  if (at == textures_.end()) return;
  last = std::move(at->second);
  textures_.erase(at);
}

}  // namespace legacy_gl
