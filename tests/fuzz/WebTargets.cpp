// What reaches the page's server: agents' drawings, pages' commands, recordings.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "fuzz/Targets.h"
#include "web/DrawingSets.h"
#include "web/MatchFile.h"
#include "web/PageCommand.h"
#include "web/RoboVizParser.h"

namespace plumbline::fuzz {

using namespace web;

void roboViz(std::string_view bytes) {
  std::vector<DrawingCommand> commands;
  parseDrawings(bytes, commands);
  require(commands.size() <= maxDatagram, "more commands than bytes");
  DrawingSets sets;
  for (const DrawingCommand& command : commands) sets.apply(command);
  sets.apply(SwapSets{""});
  require(nlohmann::json::accept(sets.toJson()), "the drawings' text is no JSON");
}

void pageCommand(std::string_view bytes) {
  PageCommand command;
  parsePageCommand(bytes, command);
  if (const auto* trainer = std::get_if<simspark::TrainerCommand>(&command)) {
    simspark::TrainerCommandParser parser;
    std::vector<simspark::TrainerCommand> again;
    require(parser.parse(writeTrainerCommand(*trainer), again).empty(),
            "a page's command is none of a trainer");
  }
}

void matchFile(std::string_view bytes) {
  const int fd = memfd_create("match", MFD_CLOEXEC);
  require(fd >= 0, "no memory for a file");
  const bool written = write(fd, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  try {
    require(written, "no memory for a file");
    MatchReader reader("/proc/self/fd/" + std::to_string(fd));
    for (std::size_t i = 0; i < std::min<std::size_t>(reader.numChunks(), 8); ++i) {
      require(reader.chunkAt(reader.beginOf(i)) < reader.numChunks(), "a time without a chunk");
      reader.read(i);
    }
  } catch (const Broken&) {
    close(fd);
    throw;
  } catch (const std::runtime_error&) {  // refused
  }
  close(fd);
}

std::vector<std::string> roboVizSeeds() {
  using std::string_literals::operator""s;
  const std::string point = "1.0000-2.000 3.0000", colour = "\x0a\xff\x80";
  return {"\x01\x00"s + "-1.250" + " 2.500" + "0.7500" + "3.0000" + colour + "l_1\0"s,
          "\x01\x01"s + point + point + "1.5   " + colour + "a\0"s,
          "\x01\x02"s + point + "8.0000" + colour + "\0"s + "\x01\x03"s + point + "0.1000" + colour + "b\0"s,
          "\x01\x04\x03"s + "\x01\x02\x03\x80" + point + point + point + "area\0"s + "\0\0"s + "area\0"s,
          "\x02\x00"s + point + colour + "kick\0"s + "l_1.t\0"s,
          "\x02\x01\x8a"s + colour + "support\0"s + "\x02\x02\x8a"s + "\x03\x00\x01"s + "\0\0\0"s};
}

std::vector<std::string> matchFileSeeds() {
  std::string name =
      (std::filesystem::temp_directory_path() / ("fuzz-match-" + std::to_string(getpid()))).string();
  std::filesystem::remove(name);
  {
    MatchWriter writer(name);
    for (int i = 0; i < 100; ++i) {
      if (i % 40 == 0) writer.add(0.1 * i, Channel::game, R"({"kind":"game"})");
      writer.add(0.1 * i, Channel::frame, std::string(60, static_cast<char>('a' + i % 9)));
    }
  }
  std::ifstream in(name, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::filesystem::remove(name);
  return {bytes, bytes.substr(0, bytes.size() / 2), bytes.substr(0, 20)};
}

std::vector<std::string> pageCommandSeeds() {
  return {R"({"do":"kickOff","side":"left"})",
          R"({"do":"playMode","mode":"PlayOn"})",
          R"({"do":"moveRobot","side":"right","unum":8,"x":1.5,"y":-2,"z":0.4,"heading":1.57})",
          R"({"do":"moveBall","x":1,"y":2,"z":0.042})",
          R"({"do":"kickBall","x":1,"y":2,"z":3})",
          R"({"do":"speed","speed":0.5})",
          R"({"do":"step","cycles":10})",
          R"({"do":"seek","time":12.5})",
          R"({"do":"rate","rate":2})",
          R"({"do":"reset"})"};
}

namespace {
const Registered roboVizTarget({"roboViz", roboViz, roboVizSeeds, 30000});
const Registered matchFileTarget({"matchFile", matchFile, matchFileSeeds, 6000});
const Registered pageCommandTarget({"pageCommand", pageCommand, pageCommandSeeds, 40000});
}  // namespace

}  // namespace plumbline::fuzz
