#include "game/StatusReader.h"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "framework/FileLines.h"

namespace plumbline::game {

std::optional<StatusWords> statusOf(const std::string& line) {
  std::istringstream in(line);
  in.exceptions(std::ios::badbit);  // a lack of memory is not a line of another kind
  std::string status, robot, ball;
  StatusWords said;
  double x = 0, y = 0, degrees = 0, ballX = 0, ballY = 0;
  if (!(in >> status >> said.time >> robot >> x >> y >> degrees >> ball >> ballX >> ballY)) return {};
  if (status != "status" || robot != "robot" || ball != "ball" || !std::isfinite(said.time)) return {};
  std::getline(in >> std::ws, said.words);
  return said;
}

const std::vector<StatusWords>& StatusReader::read() {
  if (!std::filesystem::exists(path_)) return said_;  // not yet
  FileLines lines(path_, position_);
  for (std::string line; lines.next(line) && lines.whole();) {
    position_ = lines.end();
    if (auto said = statusOf(line); said && !said->words.empty()) said_.push_back(std::move(*said));
  }
  return said_;
}

}  // namespace plumbline::game
