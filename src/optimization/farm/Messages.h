#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optimization/Search.h"

namespace plumbline::farm {

/// What passes between the server and its clients: lines of JSON. Numbers that are none are null.
inline constexpr int protocolVersion = 1;
inline constexpr std::size_t maxLine = std::size_t{1} << 20;
inline constexpr std::size_t maxFigures = 32;

/// A client's first line.
struct Hello {
  enum class Role { worker, status } role = Role::worker;
  std::string name, token;
};

/// The server's answer to a worker: what is to be evaluated.
struct Welcome {
  std::string task;
  std::map<std::string, std::string> options{};
  std::int64_t parameters = 0;  ///< how many
};

/// A worker's costs of a trial's runs, with the means of the task's figures.
struct Answer {
  std::int64_t number = 0;
  std::vector<double> costs{};
  std::map<std::string, double> figures{};
};

std::string text(const Hello& hello);
std::string text(const Welcome& welcome);
std::string text(const Trial& trial);
std::string text(const Answer& answer);

// Each throws std::invalid_argument, one line, for a line that is no such message.
Hello readHello(std::string_view line);
Answer readAnswer(std::string_view line);

/// What the server sends to a worker: a welcome, a trial, the end (`over`), or why the server drops it
/// (`error`).
struct ToWorker {
  std::optional<Welcome> welcome{};
  std::optional<Trial> trial{};
  std::string over{}, error{};
};
ToWorker readToWorker(std::string_view line);

}  // namespace plumbline::farm
