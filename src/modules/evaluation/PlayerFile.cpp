#include "modules/evaluation/PlayerFile.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace plumbline {

void openPlayerFile(std::ofstream& out, const std::string& folder, const PlayerInfo& player,
                    const std::string& columns) {
  if (out.is_open()) return;
  std::filesystem::create_directories(folder);
  const std::string file =
      fmt::format("{}/{}-{}.csv", folder, player.leftSide ? "left" : "right", player.number);
  out.open(file);
  if (!out) throw std::runtime_error("cannot write " + file);
  out << columns << '\n';
}

}  // namespace plumbline
