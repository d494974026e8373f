#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "watch/GameWatch.h"

namespace plumbline::watch {

using simspark::TeamSide;

const char* const gameLogHeader =
    "date,server,left,right,seed,half_time_s,score_left,score_right,falls_left,falls_right,kicks_left,"
    "kicks_right,players_left,players_right,game_s,wall_s,end,touching_left,touching_right,charging_left,"
    "charging_right,illegal_defence_left,illegal_defence_right,free_kicks_against_left,"
    "free_kicks_against_right,passes_left,passes_right,passes_completed_left,passes_completed_right,"
    "shots_left,shots_right";

namespace {

std::string field(std::string text) {
  if (text.empty()) return "-";
  for (char& c : text)
    if (c == ',' || c == '"' || static_cast<unsigned char>(c) < ' ') c = '_';
  return text;
}

}  // namespace

std::string gameLogLine(const GameLogEntry& entry, const GameResult& result) {
  const GameCounter& counts = result.counts;
  const auto left = TeamSide::left, right = TeamSide::right;
  std::string line =
      fmt::format("{},{},{},{},{},{:g},{},{},{},{},{},{},{},{},{:.2f},{:.1f},{}", field(entry.date),
                  field(entry.server), field(entry.nameLeft.empty() ? result.teamLeft : entry.nameLeft),
                  field(entry.nameRight.empty() ? result.teamRight : entry.nameRight), field(entry.seed),
                  entry.halfTime, result.scoreLeft, result.scoreRight, counts.falls(left),
                  counts.falls(right), counts.kicks(left), counts.kicks(right), counts.players(left),
                  counts.players(right), result.gameSeconds, result.wallSeconds, gameEndText(result.end));
  for (const auto kind :
       {simspark::FoulKind::touching, simspark::FoulKind::charging, simspark::FoulKind::illegalDefence})
    line += fmt::format(",{},{}", counts.fouls(left, kind), counts.fouls(right, kind));
  line += fmt::format(",{},{}", counts.freeKicksAgainst(left), counts.freeKicksAgainst(right));
  return line + fmt::format(",{},{},{},{},{},{}", counts.passesMade(left), counts.passesMade(right),
                            counts.passesCompleted(left), counts.passesCompleted(right), counts.shots(left),
                            counts.shots(right));
}

void appendGameLog(const std::string& file, const std::string& line) {
  const auto fail = [&] { throw std::runtime_error("cannot write " + file + ": " + std::strerror(errno)); };
  const int fd = open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (fd < 0) fail();
  struct stat status {};
  std::string text;
  bool good = flock(fd, LOCK_EX) == 0 && fstat(fd, &status) == 0;
  if (status.st_size == 0) text = std::string(gameLogHeader) + '\n';
  text += line + '\n';
  good = good && write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int problem = errno;
  close(fd);
  errno = problem;
  if (!good) fail();
}

}  // namespace plumbline::watch
