#pragma once
// The numbers of src/software that measurement chose.
#include <cstdint>

namespace legacy_gl::tuning {

/// A small draw is lit on the CPU when it has no more vertices than this. Measured on 2026-12-01 on
/// llvmpipe 22.3.6 by scripts/fast_path_worth, in per cent of the CPU time with 128 (+: slower).
/// 64: five turns, thirteen programs; the others: one turn.
///                16     32     64   none lit
///   pinion       -6     -3    -17     -9
///   gears        -8     -8     -8     -9
///   engine       -5     -6     -4     -4
///   topblock    +36    +38      0    +32
///   juggler3d   +12    +10      0    +11
///   molecule     +7     +9     -1    +11
///   enemylines3  +7     -5     +5      ?
/// cage, dangerball, glknots, pipes, sballs, stonerview: within 1.4 at 64. Waiting after batches
/// that did not save draws enough (a draw for 16, 32 or 64 vertices) served juggler3d and molecule
/// worse: +8 to +15.
inline constexpr std::uint32_t kMostLitVertices = 64;

}  // namespace legacy_gl::tuning
