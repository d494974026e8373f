#include "framework/PartialFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

fs::path someFolder(const char* name) {
  fs::path folder = fs::path(testing::TempDir()) / name;
  fs::create_directories(folder / "inner");
  std::ofstream(folder / "inner" / "file") << "text";
  return folder;
}

TEST(PartialFolder, goesWithWhatIsInIt) {
  const fs::path folder = someFolder("goes.part");
  try {
    const PartialFolder part(folder);
    throw std::runtime_error("in the midst of it");
  } catch (const std::runtime_error&) {
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(PartialFolder, staysWhenKept) {
  const fs::path folder = someFolder("kept.part");
  {
    PartialFolder part(folder);
    part.keep();
  }
  EXPECT_TRUE(fs::exists(folder / "inner" / "file"));
  fs::remove_all(folder);
}

TEST(PartialFolder, allThatAreNotKeptGoAtOnce) {
  const fs::path one = someFolder("one.part"), kept = someFolder("three.part");
  const PartialFolder first(one);
  PartialFolder third(kept);
  third.keep();
  { const PartialFolder second(someFolder("two.part")); }
  PartialFolder::removeAll();
  EXPECT_FALSE(fs::exists(one));
  EXPECT_TRUE(fs::exists(kept / "inner" / "file"));
  fs::remove_all(kept);
}

TEST(PartialFolder, oneThatIsNotThereIsNoMatter) { EXPECT_NO_THROW(PartialFolder("nowhere/at.part")); }

}  // namespace
}  // namespace plumbline
