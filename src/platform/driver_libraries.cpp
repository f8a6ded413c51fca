#include "platform/driver_libraries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace legacy_gl::platform {

namespace {

using GetProcAddress = Function (*)(const char*);

std::string directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

bool is_same_file(const std::string& a, const std::string& b) {
  char* const real_a = realpath(a.c_str(), nullptr);
  char* const real_b = realpath(b.c_str(), nullptr);
  const bool same = real_a && real_b && std::string(real_a) == real_b;
  std::free(real_a);
  std::free(real_b);
  return same;
}

/// Where this library was loaded from.
std::string own_path() {
  Dl_info info{};
  static const int anchor = 0;
  return dladdr(&anchor, &info) && info.dli_fname ? info.dli_fname : "";
}

void* own_library() {
  static void* const library = dlopen(own_path().c_str(), RTLD_LAZY | RTLD_NOLOAD);
  return library;
}

/// The directories that the dynamic linker searches for what this library needs.
std::vector<std::string> search_path() {
  std::vector<std::string> directories;
  void* const library = own_library();
  Dl_serinfo size{};
  if (!library || dlinfo(library, RTLD_DI_SERINFOSIZE, &size) != 0) return directories;
  std::vector<char> memory(size.dls_size);
  auto* const info = reinterpret_cast<Dl_serinfo*>(memory.data());
  if (dlinfo(library, RTLD_DI_SERINFOSIZE, info) != 0 ||
      dlinfo(library, RTLD_DI_SERINFO, info) != 0)
    return directories;
  for (unsigned i = 0; i < info->dls_cnt; ++i)
    directories.emplace_back(info->dls_serpath[i].dls_name);
  return directories;
}

/// Opens the next library of that name behind the drop-in's own directory.
void* open_behind(const char* name) {
  const std::string own_directory = directory_of(own_path());
  for (const std::string& directory : search_path()) {
    if (is_same_file(directory, own_directory)) continue;
    if (void* const library = dlopen((directory + "/" + name).c_str(), RTLD_LAZY | RTLD_LOCAL))
      return library;
  }
  std::fprintf(stderr, "legacy_gl: %s: the driver's library is not found\n", name);
  return nullptr;
}

void* glx_library() {
  static void* const library = [] {
    void* const opened = dlopen("libGLX.so.0", RTLD_LAZY | RTLD_LOCAL);
    if (!opened) std::fprintf(stderr, "legacy_gl: %s\n", dlerror());
    return opened;
  }();
  return library;
}

void* egl_library() {
  static void* const library = open_behind("libEGL.so.1");
  return library;
}

Function find_symbol(void* library, const char* name) {
  return library ? reinterpret_cast<Function>(dlsym(library, name)) : nullptr;
}

}  // namespace

Function find_glx(const char* name) {
  if (const Function function = find_symbol(glx_library(), name)) return function;
  static const auto get_proc_address =
      reinterpret_cast<GetProcAddress>(find_symbol(glx_library(), "glXGetProcAddressARB"));
  return get_proc_address ? get_proc_address(name) : nullptr;
}

Function find_egl(const char* name) {
  if (const Function function = find_symbol(egl_library(), name)) return function;
  static const auto get_proc_address =
      reinterpret_cast<GetProcAddress>(find_symbol(egl_library(), "eglGetProcAddress"));
  return get_proc_address ? get_proc_address(name) : nullptr;
}

Function find_gl(const char* name) {
  static const auto get_proc_address =
      reinterpret_cast<GetProcAddress>(find_symbol(glx_library(), "glXGetProcAddressARB"));
  return get_proc_address ? get_proc_address(name) : find_egl(name);
}

Function find_exported(const char* name) {
  if (!own_library()) return nullptr;
  const Function function = find_symbol(own_library(), name);
  Dl_info info{};
  // dlsym also answers with what the libraries below have.
  if (!function || !dladdr(reinterpret_cast<void*>(function), &info)) return nullptr;
  return own_path() == info.dli_fname ? function : nullptr;
}

void report_missing(const char* name) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard lock(mutex);
  if (said.insert(name).second)
    std::fprintf(stderr, "legacy_gl: the driver's libraries have no %s\n", name);
}

}  // namespace legacy_gl::platform
