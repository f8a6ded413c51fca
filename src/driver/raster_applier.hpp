#pragma once
#include <cstdint>

#include "driver/driver.hpp"
#include "state/clip_planes.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// Hands the raster state to the driver, as far as it differs from what the driver has.
class RasterApplier {
 public:
  void apply(const Driver& driver, const RasterState& wanted, std::uint8_t clip_planes);
  /// The driver refuses lines wider than one pixel.
  void keep_lines_thin() { thin_lines_ = true; }
  /// The driver's state is unknown: the next apply hands on everything.
  void forget() { known_ = false; }

 private:
  bool known_ = false;
  bool thin_lines_ = false;
  RasterState driver_state_;
  std::uint8_t clip_planes_ = 0;
};

}  // namespace legacy_gl
