// What is remembered of draws stays bounded, in number and in memory.
#include "software/recent_entries.hpp"

#include <gtest/gtest.h>

namespace legacy_gl {
namespace {

struct Entry {
  int name = 0;
  std::uint64_t last_used = 0;
  unsigned seen = 0;
  std::shared_ptr<ListMesh> mesh;
};

class RecentEntriesTest : public testing::Test {
 protected:
  Entry& use(int name) {
    Entry fresh;
    fresh.name = name;
    return entries_.find_or_add([name](const Entry& entry) { return entry.name == name; }, fresh);
  }
  // In parts of what all meshes together may take.
  void give_mesh(int name, double part) {
    Entry& entry = use(name);
    entry.seen = 3;
    entry.mesh = std::make_shared<ListMesh>();
    entry.mesh->vertices.resize(
        static_cast<std::size_t>(part * static_cast<double>(RecentEntries<Entry>::kMostFloats)));
    entries_.make_room();
  }

  RecentEntries<Entry> entries_;
};

constexpr int kMost = RecentEntries<Entry>::kMostEntries;

TEST_F(RecentEntriesTest, AreFoundAgain) {
  for (int name = 0; name < kMost; ++name) use(name).seen = static_cast<unsigned>(name) + 1;
  for (int name = 0; name < kMost; ++name)
    EXPECT_EQ(use(name).seen, static_cast<unsigned>(name) + 1);
}

TEST_F(RecentEntriesTest, TheLeastRecentlyUsedIsForgotten) {
  for (int name = 0; name < kMost; ++name) use(name).seen = 1;
  use(0);
  use(100).seen = 1;  // in place of 1
  EXPECT_EQ(use(0).seen, 1u);
  EXPECT_EQ(use(2).seen, 1u);
  EXPECT_EQ(use(1).seen, 0u);
}

TEST_F(RecentEntriesTest, MeshesMakeRoomForNewerOnes) {
  give_mesh(1, 0.4);
  give_mesh(2, 0.4);
  use(1);
  give_mesh(3, 0.4);
  EXPECT_TRUE(use(1).mesh);
  EXPECT_FALSE(use(2).mesh);
  EXPECT_EQ(use(2).seen, 0u);
  EXPECT_TRUE(use(3).mesh);
  give_mesh(4, 1);
  EXPECT_FALSE(use(1).mesh);
  EXPECT_FALSE(use(3).mesh);
  EXPECT_TRUE(use(4).mesh);
}

}  // namespace
}  // namespace legacy_gl
