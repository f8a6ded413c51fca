#pragma once
#include <unordered_map>

#include "driver/driver.hpp"

namespace legacy_gl {

/// Occlusion queries (GL 2.1 spec 4.1.7) on the driver's. GLES can only tell whether any sample
/// passed: there the counter has one bit.
class QueryObjects {
 public:
  explicit QueryObjects(const Driver& driver) : driver_(driver) {}
  ~QueryObjects();
  QueryObjects(const QueryObjects&) = delete;
  QueryObjects& operator=(const QueryObjects&) = delete;

  void generate(GLsizei count, GLuint* names);
  void remove(GLuint name);
  /// The name has been begun once.
  bool exists(GLuint name) const;

  void begin(GLuint name);
  void end();
  /// 0: none.
  GLuint active() const { return active_; }

  GLint counter_bits() const;
  GLuint result(GLuint name, bool only_availability) const;

 private:
  GLenum target() const;

  const Driver& driver_;
  /// To the driver's name; 0: reserved, and not begun yet.
  std::unordered_map<GLuint, GLuint> objects_;
  GLuint active_ = 0;
  GLuint last_generated_ = 0;
};

}  // namespace legacy_gl
