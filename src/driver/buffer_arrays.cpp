#include "driver/buffer_arrays.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace legacy_gl {

namespace {

/// A program that points elsewhere for each draw must not fill the memory: beyond this all are made
/// anew.
constexpr std::size_t kMaxArrays = 4096;

}  // namespace

BufferArrays::~BufferArrays() { clear(); }

void BufferArrays::clear() {
  for (const auto& [key, array] : arrays_) driver_.DeleteVertexArrays(1, &array);
  arrays_.clear();
}

std::size_t BufferArrays::Hash::operator()(const BufferAttributes& key) const noexcept {
  std::uint64_t hash = key.index_buffer ^ key.index_serial << 32;
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  };
  for (unsigned i = 0; i < key.count; ++i) {
    const BufferAttribute& attribute = key.attributes[i];
    mix(attribute.serial << 32 | attribute.type << 8 | attribute.location);
    mix(static_cast<std::uint64_t>(attribute.stride) << 3 | static_cast<unsigned>(attribute.size));
    mix(reinterpret_cast<std::uintptr_t>(attribute.offset));
  }
  return hash;
}

GLuint BufferArrays::find_or_build(const BufferAttributes& wanted) {
  if (const auto at = arrays_.find(wanted); at != arrays_.end()) return at->second;
  if (arrays_.size() == kMaxArrays) clear();
  return arrays_.emplace(wanted, build(wanted)).first->second;
}

GLuint BufferArrays::build(const BufferAttributes& wanted) {
  GLuint array = 0;
  driver_.GenVertexArrays(1, &array);
  driver_.BindVertexArray(array);
  driver_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, wanted.index_buffer);
  for (unsigned i = 0; i < wanted.count; ++i) {
    const BufferAttribute& attribute = wanted.attributes[i];
    driver_.BindBuffer(GL_ARRAY_BUFFER, attribute.buffer);
    driver_.EnableVertexAttribArray(attribute.location);
    driver_.VertexAttribPointer(attribute.location, attribute.size, attribute.type,
                                attribute.normalised ? GL_TRUE : GL_FALSE, attribute.stride,
                                attribute.offset);
  }
  return array;
}

void BufferArrays::forget(std::uint64_t buffer) {
  for (auto at = arrays_.begin(); at != arrays_.end();) {
    const BufferAttributes& key = at->first;
    const auto end = key.attributes.begin() + key.count;
    const bool refers = key.index_serial == buffer ||
                        std::any_of(key.attributes.begin(), end, [buffer](const auto& attribute) {
                          return attribute.serial == buffer;
                        });
    if (refers) driver_.DeleteVertexArrays(1, &at->second);
    at = refers ? arrays_.erase(at) : std::next(at);
  }
}

}  // namespace legacy_gl
