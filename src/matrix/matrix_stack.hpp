#pragma once
#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

namespace legacy_gl {

/// One matrix, kept twice. `single` follows GL's float32 arithmetic operation by operation, so that
/// positions (and multipass rendering) agree bit for bit with a fixed-function driver; `exact` is
/// what lighting derives from: after a thousand stacked rotations `single` is wrong by 3e-3 of a
/// colour step, `exact` by 5e-5.
struct Matrix {
  glm::mat4 single{1.0f};
  glm::dmat4 exact{1.0};
};

void set_identity(Matrix& matrix);
void load(Matrix& matrix, const glm::mat4& values);
void multiply(Matrix& matrix, const glm::mat4& right);
void rotate(Matrix& matrix, float degrees, float x, float y, float z);
void translate(Matrix& matrix, float x, float y, float z);
void scale(Matrix& matrix, float x, float y, float z);
void frustum(Matrix& matrix, double left, double right, double bottom, double top,
             double near_distance, double far_distance);
void ortho(Matrix& matrix, double left, double right, double bottom, double top,
           double near_distance, double far_distance);

/// GL 2.1 spec 2.11.2. Never empty.
class MatrixStack {
 public:
  explicit MatrixStack(std::size_t max_depth) : max_depth_(max_depth) {
    matrices_.reserve(max_depth);
    matrices_.emplace_back();
  }
  Matrix& top() { return matrices_.back(); }
  const Matrix& top() const { return matrices_.back(); }
  std::size_t depth() const { return matrices_.size(); }
  std::size_t max_depth() const { return max_depth_; }
  bool can_push() const { return matrices_.size() < max_depth_; }
  bool can_pop() const { return matrices_.size() > 1; }
  void push() { matrices_.push_back(matrices_.back()); }
  void pop() { matrices_.pop_back(); }

 private:
  std::size_t max_depth_;
  std::vector<Matrix> matrices_;
};

}  // namespace legacy_gl
