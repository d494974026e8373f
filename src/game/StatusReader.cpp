#include "game/StatusReader.h"

#include <sstream>

namespace plumbline::game {

std::string wordsOfStatus(const std::string& line) {
  std::istringstream in(line);
  std::string status, robot, ball, words;
  double time = 0, x = 0, y = 0, degrees = 0, ballX = 0, ballY = 0;
  if (!(in >> status >> time >> robot >> x >> y >> degrees >> ball >> ballX >> ballY)) return {};
  if (status != "status" || robot != "robot" || ball != "ball") return {};
  std::getline(in >> std::ws, words);
  return words;
}

const std::string& StatusReader::read() {
  std::ifstream file(path_);
  file.seekg(position_);
  for (std::string line; std::getline(file, line) && !file.eof();) {
    position_ = file.tellg();
    if (std::string words = wordsOfStatus(line); !words.empty()) words_ = std::move(words);
  }
  return words_;
}

}  // namespace plumbline::game
