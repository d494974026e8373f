#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "PlayAll.h"
#include "SetPiece.h"
#include "framework/WriteFile.h"
#include "gap/blind/BlindScore.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

namespace plumbline::bench {
namespace {

using Results = std::vector<SetPieceResult>;

std::string shareOf(std::ptrdiff_t yes, std::size_t all) {
  if (all == 0) return "-";
  const gap::Figure share = gap::share("", "", static_cast<std::size_t>(yes), all);
  return fmt::format("{:.0f} ({:.0f} to {:.0f})", 100 * share.value, 100 * share.lower, 100 * share.upper);
}

/// Mean with its 95 % interval.
std::string meanOf(const Results& results, double SetPieceResult::*what) {
  const auto count = static_cast<double>(results.size());
  if (results.empty()) return "-";
  double sum = 0, squares = 0;
  for (const SetPieceResult& result : results) sum += result.*what;
  const double mean = sum / count;
  for (const SetPieceResult& result : results) squares += std::pow(result.*what - mean, 2);
  if (results.size() < 2) return fmt::format("{:.1f}", mean);
  return fmt::format("{:.1f} ± {:.1f}", mean, 1.96 * std::sqrt(squares / (count - 1) / count));
}

const char* const text =
    "{} set pieces of each kind, {} against {}, seeds from {}. Places are drawn from the seed: a player of "
    "the "
    "team 1.5 to 4 m from the ball, the others 3 to 9 m, opponents 2.5 to 8 m, a goalie on each side. A "
    "kick-off follows a goal of the other team, so all come to their places by themselves. {} A piece ends "
    "with a goal, when the ball is out of play, or {:.0f} s after the kick. Shares in percent with 95 % "
    "intervals (Wilson), means with theirs. The first column is of all pieces, the others are of those "
    "taken. "
    "A trainer's messages reach the simulator at any cycle, so the same seeds do not repeat a piece.\n\n"
    "| | taken before the drop ball | after [s] | next touch: a mate's | an opponent's | ball gained in "
    "{:.0f} s "
    "[m] | ball kept for {:.0f} s | goals | goals against | free kick for double touch |\n"
    "|---|---|---|---|---|---|---|---|---|---|\n";

/// Those named, separated by commas; all if none is. Throws std::runtime_error.
std::vector<SetPieceKind> kindsOf(const std::string& names) {
  std::vector<SetPieceKind> kinds;
  std::istringstream words(names);
  for (std::string word; std::getline(words, word, ',');) {
    const auto at = std::ranges::find(setPieceNames, word);
    if (at == setPieceNames.end()) throw std::runtime_error("KINDS has \"" + word + "\", which is none");
    kinds.push_back(static_cast<SetPieceKind>(at - setPieceNames.begin()));
  }
  if (kinds.empty())
    for (std::size_t i = 0; i < setPieceNames.size(); ++i) kinds.push_back(static_cast<SetPieceKind>(i));
  return kinds;
}

std::string row(SetPieceKind kind, const Results& all, nlohmann::json& figures) {
  Results taken;
  std::ranges::copy_if(all, std::back_inserter(taken), &SetPieceResult::taken);
  const auto count = [&](bool SetPieceResult::*what) { return std::ranges::count(taken, true, what); };
  const auto share = [&](bool SetPieceResult::*what) { return shareOf(count(what), taken.size()); };
  const char* title = setPieceNames[static_cast<std::size_t>(kind)];
  std::string name = title;
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == '-'; }, '_');
  const auto figure = [&](const char* what, double value, const char* unit, const char* better) {
    figures.push_back(figureJson(fmt::format("set-pieces.{}.{}", name, what), value, unit, better));
  };
  const auto percent = [](auto part, std::size_t whole) {
    return whole > 0 ? 100 * static_cast<double>(part) / static_cast<double>(whole) : 0;
  };
  double gain = 0;
  for (const SetPieceResult& result : taken) gain += result.gain / static_cast<double>(taken.size());
  figure("taken", percent(taken.size(), all.size()), "%", "higher");
  figure("next_touch", percent(count(&SetPieceResult::ours), taken.size()), "%", "higher");
  figure("gain", gain, "m", "higher");
  figure("kept", percent(count(&SetPieceResult::kept), taken.size()), "%", "higher");
  figure("goals", percent(count(&SetPieceResult::goal), taken.size()), "%", "higher");
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", title,
                     shareOf(static_cast<std::ptrdiff_t>(taken.size()), all.size()),
                     meanOf(taken, &SetPieceResult::seconds), share(&SetPieceResult::ours),
                     share(&SetPieceResult::theirs), meanOf(taken, &SetPieceResult::gain),
                     share(&SetPieceResult::kept), share(&SetPieceResult::goal),
                     share(&SetPieceResult::against), share(&SetPieceResult::doubleTouch));
}

}  // namespace

void measureSetPieces() {
  const auto tries = static_cast<int>(environment("TRIES", 100));
  const auto jobs = static_cast<int>(environment("JOBS", std::max(1U, std::thread::hardware_concurrency())));
  const auto players = static_cast<int>(environment("PLAYERS", 5));
  const std::uint64_t seed = environment("SEED", 1);
  if (tries < 1 || jobs < 1 || jobs > 64 || players < 2 || players > 11)
    throw std::runtime_error("TRIES is 1 or more, JOBS is 1 to 64, PLAYERS is 2 to 11");
  const std::string folder = "build/bench/set-pieces", others = environmentText("OTHERS", "");
  std::filesystem::remove_all(folder);
  const std::vector<SetPieceKind> kinds = kindsOf(environmentText("KINDS", ""));
  const SetPieceOptions options{"bin", others, folder, players};
  const auto results =
      playAll<SetPieceGame>("set-pieces", "pieces", options, static_cast<int>(kinds.size()) * tries, jobs,
                            seed, [&](SetPieceGame& game, int i) {
                              return game.play(kinds[static_cast<std::size_t>(i / tries)],
                                               seed + static_cast<std::uint64_t>(i % tries));
                            });
  nlohmann::json figures = nlohmann::json::array();
  std::string page =
      fmt::format(fmt::runtime(text), tries, players, players, seed,
                  others.empty() ? "The other team is the same." : "The other team plays by " + others + ".",
                  SetPieceGame::longest, SetPieceGame::gainAfter, SetPieceGame::keptAfter);
  for (const SetPieceKind kind : kinds) {
    Results own;
    std::ranges::copy_if(results, std::back_inserter(own),
                         [kind](const SetPieceResult& result) { return result.kind == kind; });
    page += row(kind, own, figures);
  }
  page += '\n';
  writeFile(folder + ".json", figures.dump(1) + "\n");
  writeFile(folder + ".md", page);
  fmt::print("{}", page);
}

}  // namespace plumbline::bench
