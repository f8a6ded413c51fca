#include "driver/query_objects.hpp"

namespace legacy_gl {

namespace {

// Of GLES 3.0, and of OpenGL since 3.3.
constexpr GLenum kAnySamplesPassed = 0x8C2F;

}  // namespace

QueryObjects::~QueryObjects() {
  for (const auto& [name, driver_name] : objects_)
    if (driver_name) driver_.DeleteQueries(1, &driver_name);
}

GLenum QueryObjects::target() const {
  return driver_.is_es() ? kAnySamplesPassed : GLenum{GL_SAMPLES_PASSED};
}

void QueryObjects::generate(GLsizei count, GLuint* names) {
  for (GLsizei i = 0; i < count; ++i) {
    do ++last_generated_;
    while (last_generated_ == 0 || objects_.contains(last_generated_));
    objects_[last_generated_] = 0;
    names[i] = last_generated_;
  }
}

void QueryObjects::remove(GLuint name) {
  const auto at = objects_.find(name);
  if (at == objects_.end()) return;
  if (name == active_) end();
  if (at->second) driver_.DeleteQueries(1, &at->second);
  objects_.erase(at);
}

bool QueryObjects::exists(GLuint name) const {
  const auto at = objects_.find(name);
  return at != objects_.end() && at->second != 0;
}

void QueryObjects::begin(GLuint name) {
  GLuint& driver_name = objects_[name];
  if (!driver_name) driver_.GenQueries(1, &driver_name);
  driver_.BeginQuery(target(), driver_name);
  active_ = name;
}

void QueryObjects::end() {
  driver_.EndQuery(target());
  active_ = 0;
}

GLint QueryObjects::counter_bits() const {
  if (driver_.is_es()) return 1;
  GLint bits = 0;
  driver_.GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
  return bits;
}

GLuint QueryObjects::result(GLuint name, bool only_availability) const {
  GLuint value = 0;
  driver_.GetQueryObjectuiv(
      objects_.at(name), only_availability ? GL_QUERY_RESULT_AVAILABLE : GL_QUERY_RESULT, &value);
  return value;
}

}  // namespace legacy_gl
