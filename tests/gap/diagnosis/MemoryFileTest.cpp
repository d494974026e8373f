#include "gap/diagnosis/MemoryFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace plumbline::gap {
namespace {

using nlohmann::json;

class MemoryFileTest : public ::testing::Test {
protected:
  MemoryFileTest() { std::filesystem::remove_all(path); }
  ~MemoryFileTest() override { std::filesystem::remove_all(path); }

  MemoryFile file(const std::string& mark = "mark") {
    return {path, mark, [this](const std::string& line) { said.push_back(line); }};
  }
  /// What is stored under a mark; null: nothing.
  json content(const std::string& mark = "mark") {
    json found;
    file(mark).read([&](const json& stored) { found = stored; });
    return found;
  }
  std::string text() const {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& text) { std::ofstream(path) << text; }

  const std::string path = ::testing::TempDir() + "plumbline-memory-file";
  std::vector<std::string> said;
};

TEST_F(MemoryFileTest, givesBackWhatWasStoredToTheLastBit) {
  const json stored = {{"numbers", {0.1, -0.0, 1e-310, 1.0 / 3, std::numeric_limits<double>::max(), 3}}};
  EXPECT_TRUE(content().is_null());
  EXPECT_TRUE(file().write(stored));
  EXPECT_EQ(content().dump(), stored.dump());
  EXPECT_EQ(content()["numbers"][3].get<double>(), 1.0 / 3);
  EXPECT_TRUE(std::signbit(content()["numbers"][1].get<double>()));
  EXPECT_TRUE(said.empty());
  file().forget();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(MemoryFileTest, aFileOfAnotherMarkIsNotTaken) {
  file().write({1});
  EXPECT_TRUE(content("other").is_null());
  EXPECT_EQ(said,
            std::vector<std::string>{path + ": is of other recordings, other options or another version of "
                                            "the program; the diagnosis begins anew"});
}

TEST_F(MemoryFileTest, aDamagedFileIsNotTaken) {
  file().write({{"value", 0.25}});
  const std::string good = text();
  const std::string one = good.substr(0, good.size() - 3);
  std::string other = good;
  other.replace(good.find("0.25"), 4, "0.26");  // is JSON, and another value
  for (const std::string& damaged : {one, other, std::string(), std::string("[1]"), std::string("\0\1", 2),
                                     std::string(R"({"mark": "mark"})")}) {
    said.clear();
    put(damaged);
    EXPECT_TRUE(content().is_null()) << damaged;
    EXPECT_EQ(said, std::vector<std::string>{path + ": is damaged; the diagnosis begins anew"}) << damaged;
  }
  put(good);
  EXPECT_EQ(content()["value"], 0.25);
  // Good, but not what its reader expects.
  EXPECT_FALSE(file().read([](const json& stored) { stored.at("other"); }));
  EXPECT_EQ(said.back(), path + ": is damaged; the diagnosis begins anew");
}

TEST_F(MemoryFileTest, aFileThatIsTooLargeIsNotRead) {
  put("");
  std::filesystem::resize_file(path, (std::uintmax_t{64} << 20) + 1);
  EXPECT_TRUE(content().is_null());
  EXPECT_EQ(said, std::vector<std::string>{path + ": is larger than 64 MB; the diagnosis begins anew"});
}

TEST_F(MemoryFileTest, aFileThatCannotBeWrittenIsReportedOnceAndStopsNothing) {
  std::filesystem::create_directory(path);
  MemoryFile memory = file();
  EXPECT_FALSE(memory.write({1}));
  EXPECT_FALSE(memory.write({1}));
  EXPECT_TRUE(content().is_null());
  memory.forget();
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(said, std::vector<std::string>{
                      "cannot write " + path +
                      ": Is a directory; a diagnosis that is stopped from now on repeats what follows"});
}

TEST_F(MemoryFileTest, withoutAPathNothingIsStored) {
  MemoryFile none("", "mark", [this](const std::string& line) { said.push_back(line); });
  EXPECT_FALSE(none.write({1}));
  EXPECT_FALSE(none.read([](const json&) { FAIL(); }));
  none.forget();
  EXPECT_TRUE(said.empty());
}

}  // namespace
}  // namespace plumbline::gap
