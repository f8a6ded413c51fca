# Sourced by the scripts beside it.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

step() { printf '==> %s\n' "$*" >&2; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# configure_and_build <preset> [<argument of cmake --build>...]
configure_and_build() {
  local preset=$1
  shift
  step "Configuring ($preset)"
  (cd "$repository" && cmake --preset "$preset")
  step "Building ($preset, $jobs jobs)"
  (cd "$repository" && cmake --build --preset "$preset" --parallel "$jobs" "$@")
}
