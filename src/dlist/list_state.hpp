#pragma once
#include <memory>

#include "dlist/display_list.hpp"
#include "dlist/list_welder.hpp"
#include "state/gl_types.hpp"
#include "state/shared_names.hpp"

namespace legacy_gl {

/// A list is replaced whole when glEndList is called, and lives on while it is being executed.
using ListNames = SharedNames<const DisplayList>;

struct ListState {
  std::shared_ptr<ListNames> names = std::make_shared<ListNames>();
  std::shared_ptr<DisplayList> compiling_list;  ///< nullptr while none is compiled
  ListWelder welder;

  /// Memory ran out while the list was compiled. It is given up: glEndList leaves what the name had
  /// before (GL 2.1 spec 5.4).
  bool failed = false;
  void give_up() noexcept {
    failed = true;
    welder = {};
    *compiling_list = {};
  }

  /// glEnd was recorded.
  void weld() {
    if (!failed) welder.weld_last_primitive(*compiling_list);
  }
  /// What a recorded command points to lives as long as the list.
  void keep(std::shared_ptr<const void> object) {
    if (compiling_list) compiling_list->keep(std::move(object));
  }
  /// Not of a list that has failed.
  void* append(PlayFunction play, std::size_t size) { return compiling_list->append(play, size); }
};

}  // namespace legacy_gl
