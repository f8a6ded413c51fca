#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "dlist/display_list.hpp"
#include "dlist/list_welder.hpp"
#include "state/gl_types.hpp"

namespace legacy_gl {

/// The names and lists that contexts which share see alike. A list is replaced whole when glEndList
/// is called, and lives on while it is being executed.
class ListNames {
 public:
  std::shared_ptr<const DisplayList> find(GLuint name) const;
  bool contains(GLuint name) const;
  void store(GLuint name, std::shared_ptr<const DisplayList> list);
  void erase(GLuint first, GLuint count);
  /// The first of `count` unused names in a row, each now an empty list; 0 when there are none.
  GLuint generate(GLuint count);

 private:
  mutable std::mutex mutex_;
  std::map<GLuint, std::shared_ptr<const DisplayList>> lists_;
};

struct ListState {
  std::shared_ptr<ListNames> names = std::make_shared<ListNames>();
  std::shared_ptr<DisplayList> compiling_list;  ///< nullptr while none is compiled
  ListWelder welder;

  /// glEnd was recorded.
  void weld() { welder.weld_last_primitive(*compiling_list); }
  /// What a recorded command points to lives as long as the list.
  void keep(std::shared_ptr<const void> object) {
    if (compiling_list) compiling_list->keep(std::move(object));
  }
  void* append(PlayFunction play, std::size_t size) { return compiling_list->append(play, size); }
};

}  // namespace legacy_gl
