#include "web/MatchFile.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <zlib.h>

#include <filesystem>

namespace plumbline::web {
namespace {

namespace fs = std::filesystem;

class MatchFile : public ::testing::Test {
protected:
  MatchFile() {
    folder = fs::temp_directory_path() / ("match" + std::to_string(::getpid()) +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
    file = folder / "match.plm";
  }
  ~MatchFile() override { fs::remove_all(folder); }

  static std::string frame(int i) {
    std::string bytes(500, 'f');
    for (std::size_t k = 0; k < bytes.size(); k += 7)
      bytes[k] = static_cast<char>(i * 31 + static_cast<int>(k));
    return bytes;
  }
  /// Ten seconds: 25 frames a second, the game's state now and then.
  void write() {
    MatchWriter writer(file);
    writer.add(0, Channel::geometry, "geometry");
    for (int i = 0; i < 250; ++i) {
      const double time = 0.04 * i;
      if (i % 60 == 0) writer.add(time, Channel::game, "game " + std::to_string(i));
      if (i == 100) writer.add(time, Channel::drawings, "drawings");
      writer.add(time, Channel::frame, frame(i));
    }
  }
  std::string problem() {
    try {
      MatchReader reader(file);
      for (std::size_t i = 0; i < reader.numChunks(); ++i) reader.read(i);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }
  std::string bytes() {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void overwrite(const std::string& text) { std::ofstream(file, std::ios::binary | std::ios::trunc) << text; }

  /// A file of one chunk that holds these bytes, packed.
  void writeChunk(const std::string& records) {
    uLongf size = compressBound(records.size());
    std::string packed(size, '\0');
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                       reinterpret_cast<const Bytef*>(records.data()), records.size()),
              Z_OK);
    const std::uint32_t numbers[] = {static_cast<std::uint32_t>(size),
                                     static_cast<std::uint32_t>(records.size()), 0};
    const double times[] = {0, 1};
    overwrite(std::string("PLUMBLINE MATCH\n\1\0\0\0CHNK", 24) +
              std::string(reinterpret_cast<const char*>(numbers), sizeof numbers) +
              std::string(reinterpret_cast<const char*>(times), sizeof times) + packed.substr(0, size));
  }
  /// A record of 500 ms with this channel, and a length that its text need not have.
  static std::string record(char channel, char length, const std::string& text) {
    return std::string(1, channel) + std::string("\xf4\1\0\0", 4) + length + std::string(3, '\0') + text;
  }

  fs::path folder;
  std::string file;
};

TEST_F(MatchFile, comesBackAsItWas) {
  write();
  MatchReader reader(file);
  EXPECT_EQ(reader.numChunks(), 5u);
  EXPECT_NEAR(reader.duration(), 9.96, 1e-9);
  int frames = 0;
  for (std::size_t chunk = 0; chunk < reader.numChunks(); ++chunk) {
    for (const MatchRecord& record : reader.read(chunk)) {
      if (record.channel != Channel::frame) continue;
      if (frames > 0 && record.message == frame(frames - 1)) continue;  // repeated as a chunk's beginning
      EXPECT_EQ(record.message, frame(frames));
      EXPECT_NEAR(record.time, 0.04 * frames, 0.0006);
      ++frames;
    }
  }
  EXPECT_EQ(frames, 250);
}

TEST_F(MatchFile, everyChunkStandsAlone) {
  write();
  MatchReader reader(file);
  EXPECT_EQ(reader.chunkAt(-1), 0u);
  EXPECT_EQ(reader.chunkAt(5.5), 2u);
  EXPECT_EQ(reader.chunkAt(1000), 4u);
  const auto records = reader.read(2);
  std::array<std::string, numChannels> first;
  for (const MatchRecord& record : records) {
    std::string& known = first[static_cast<std::size_t>(record.channel)];
    if (known.empty()) known = record.message;
  }
  EXPECT_EQ(first[0], "geometry");
  EXPECT_EQ(first[1], "game 60");
  EXPECT_EQ(first[3], frame(99)) << "valid until the first of its own";
  EXPECT_EQ(first[2], "drawings");
}

TEST_F(MatchFile, isSmall) {
  MatchWriter writer(file);
  std::string still(7000, 'x');
  for (int i = 0; i < 1000; ++i) writer.add(0.04 * i, Channel::frame, still);
  writer.flush();
  EXPECT_LT(fs::file_size(file), 7000u * 1000u / 100u);
}

TEST_F(MatchFile, nothingIsOverwritten) {
  write();
  const std::string before = bytes();
  try {
    MatchWriter writer(file);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), file + ": there is such a file already; remove it or record to another");
  }
  EXPECT_EQ(bytes(), before);
  try {
    MatchWriter writer(folder / "no" / "folder");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), (folder / "no" / "folder").string() + ": cannot write it");
  }
}

TEST_F(MatchFile, aRecordingThatBrokeOffLosesItsLastChunkOnly) {
  write();
  const std::string whole = bytes();
  for (const std::size_t cut : {1u, 20u, 300u}) {
    overwrite(whole.substr(0, whole.size() - cut));
    EXPECT_EQ(problem(), "");
    EXPECT_EQ(MatchReader(file).numChunks(), 4u) << cut;
  }
}

TEST_F(MatchFile, mistakesAreNamed) {
  EXPECT_EQ(problem(), file + ": cannot read it");
  overwrite("something else entirely");
  EXPECT_EQ(problem(), file + ": no match file");
  overwrite(std::string("PLUMBLINE MATCH\n\1\0\0\0", 20));
  EXPECT_EQ(problem(), file + ": nothing is recorded in it");
  overwrite(std::string("PLUMBLINE MATCH\n\2\0\0\0", 20));
  EXPECT_EQ(problem(), file + ": a match file of version 2; this program reads 1");
  fs::remove(file);
  write();
  const std::string whole = bytes();
  std::string broken = whole;
  broken[20] = 'X';
  overwrite(broken);
  EXPECT_EQ(problem(), file + ": broken at byte 20");
  broken = whole;
  broken[27] = '\x7f';  // a length of gigabytes
  overwrite(broken);
  EXPECT_EQ(problem(), file + ": broken at byte 20");
  broken = whole;
  for (std::size_t i = 60; i < 90; ++i) broken[i] = static_cast<char>(~broken[i]);
  overwrite(broken);
  EXPECT_EQ(problem(), file + ": broken in the chunk at byte 52");
}

TEST_F(MatchFile, aRecordThatIsNoneIsAMistakeOfItsChunk) {
  const std::string whole = record(1, 4, "game"),
                    mistake = file + ": a broken record in the chunk at byte 52";
  writeChunk(whole);
  EXPECT_EQ(problem(), "");
  const auto records = MatchReader(file).read(0);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].message, "game");
  EXPECT_EQ(records[0].time, 0.5);
  writeChunk(whole + whole.substr(0, 6));
  EXPECT_EQ(problem(), mistake) << "half a header";
  writeChunk(whole + record(9, 4, "what"));
  EXPECT_EQ(problem(), mistake) << "no such channel";
  writeChunk(whole + record(1, 5, "game"));
  EXPECT_EQ(problem(), mistake) << "longer than the chunk";
}

TEST_F(MatchFile, anyFlippedByteIsAnErrorOrHarmless) {
  write();
  const std::string whole = bytes();
  for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 300) {
    std::string broken = whole;
    broken[i] = static_cast<char>(broken[i] ^ 0x55);
    overwrite(broken);
    problem();  // must come back
  }
}

}  // namespace
}  // namespace plumbline::web
