#pragma once
#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <span>
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

/// A rotation, translation or scaling that is not multiplied yet.
struct MatrixOperation {
  enum class Kind { kRotate, kTranslate, kScale };
  Kind kind = Kind::kRotate;
  float x = 0, y = 0, z = 0;
  float degrees = 0;
};

/// A matrix that is not computed yet: operations on another, in their order.
struct PendingMatrix {
  const Matrix& base;
  std::span<const MatrixOperation> operations;
};

/// GL 2.1 spec 2.11.2. Never empty. What is pushed and popped again with nothing drawn in between
/// is never computed.
class MatrixStack {
 public:
  explicit MatrixStack(std::size_t max_depth) : max_depth_(max_depth) {
    matrices_.resize(max_depth);
  }
  Matrix& top() {
    compute();
    return matrices_[depth_ - 1];
  }
  const Matrix& top() const {
    compute();
    return matrices_[depth_ - 1];
  }
  PendingMatrix pending_top() const {
    return {matrices_[depth_ - (copies_below_ ? 2 : 1)], {pending_.data(), pending_count_}};
  }
  void apply(const MatrixOperation& operation) {
    if (pending_count_ == kMaxPending) compute();
    pending_[pending_count_++] = operation;
  }
  std::size_t depth() const { return depth_; }
  std::size_t max_depth() const { return max_depth_; }
  bool can_push() const { return depth_ < max_depth_; }
  bool can_pop() const { return depth_ > 1; }
  void push() {
    compute();
    ++depth_;
    copies_below_ = true;
  }
  void pop() {
    --depth_;  // the matrix below was computed when this one was pushed
    copies_below_ = false;
    pending_count_ = 0;
  }

  static constexpr std::size_t kMaxPending = 4;

 private:
  void compute() const {
    if (copies_below_ || pending_count_) compute_pending();
  }
  void compute_pending() const;

  std::size_t max_depth_;
  std::size_t depth_ = 1;
  mutable std::vector<Matrix> matrices_;
  mutable bool copies_below_ = false;  ///< the top is still to be copied from the matrix below
  mutable std::size_t pending_count_ = 0;
  std::array<MatrixOperation, kMaxPending> pending_;
};

}  // namespace legacy_gl
