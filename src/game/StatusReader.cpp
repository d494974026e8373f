#include "game/StatusReader.h"

#include <cmath>
#include <sstream>

namespace plumbline::game {

std::optional<StatusWords> statusOf(const std::string& line) {
  std::istringstream in(line);
  std::string status, robot, ball;
  StatusWords said;
  double x = 0, y = 0, degrees = 0, ballX = 0, ballY = 0;
  if (!(in >> status >> said.time >> robot >> x >> y >> degrees >> ball >> ballX >> ballY)) return {};
  if (status != "status" || robot != "robot" || ball != "ball" || !std::isfinite(said.time)) return {};
  std::getline(in >> std::ws, said.words);
  return said;
}

const std::vector<StatusWords>& StatusReader::read() {
  std::ifstream file(path_);
  file.seekg(position_);
  for (std::string line; std::getline(file, line) && !file.eof();) {
    position_ = file.tellg();
    if (auto said = statusOf(line); said && !said->words.empty()) said_.push_back(std::move(*said));
  }
  return said_;
}

}  // namespace plumbline::game
