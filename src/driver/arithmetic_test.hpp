#pragma once
#include "driver/driver.hpp"

namespace legacy_gl {

/// Draws vertices with the shader that all unlit primitives have, captures their clip coordinates
/// by transform feedback, and compares them bit by bit with the CPU's products. The driver's state
/// is as it was afterwards. False where the driver cannot capture.
bool measure_cpu_arithmetic(const Driver& driver);

/// The same, measured once for each driver and process.
bool matches_cpu_arithmetic(const Driver& driver);

}  // namespace legacy_gl
