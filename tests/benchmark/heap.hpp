#pragma once

namespace legacy_gl::test {

// With glibc's defaults the driver's scene memory goes back to the system after every frame and is
// page-faulted in again: a frame then costs five times as much, and a ratio measures luck.
void pin_heap();

}  // namespace legacy_gl::test
