#include "optimization/farm/Messages.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/Json.h"

namespace plumbline::farm {
namespace {

using nlohmann::json;

constexpr std::size_t maxName = 100;

template <typename Read>
auto parsed(std::string_view line, const char* what, Read read) {
  try {
    const json value = parseJson(line, JsonLimits{.depth = 4, .bytes = maxLine});
    if (!value.is_object()) throw std::invalid_argument(std::string(what) + ": no object");
    return read(value);
  } catch (const JsonError& error) {
    throw std::invalid_argument(std::string(what) + ": " + error.what());
  } catch (const json::exception&) {
    throw std::invalid_argument(std::string(what) + ": a key is missing or of another type");
  }
}

json numberOrNull(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

double toNumber(const json& value) { return value.is_null() ? std::nan("") : value.get<double>(); }

/// What is printed in tables and written to files: no control characters.
std::string printable(std::string name) {
  if (name.size() > maxName) name.resize(maxName);
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return name;
}

}  // namespace

std::string text(const Hello& hello) {
  json line{{"hello", hello.role == Hello::Role::worker ? "worker" : "status"},
            {"version", protocolVersion},
            {"name", hello.name}};
  if (!hello.token.empty()) line["token"] = hello.token;
  return line.dump();
}

std::string text(const Welcome& welcome) {
  return json{{"task", welcome.task}, {"options", welcome.options}, {"parameters", welcome.parameters}}
      .dump();
}

std::string text(const Trial& trial) {
  return json{{"evaluate", trial.number},
              {"parameters", std::vector<double>(trial.parameters.begin(), trial.parameters.end())},
              {"seeds", trial.seeds}}
      .dump();
}

std::string text(const Answer& answer) {
  json line{{"answer", answer.number}, {"costs", json::array()}};
  for (const double cost : answer.costs) line["costs"].push_back(numberOrNull(cost));
  for (const auto& [name, value] : answer.figures) line["figures"][name] = numberOrNull(value);
  return line.dump();
}

Hello readHello(std::string_view line) {
  return parsed(line, "hello", [](const json& value) {
    Hello hello;
    const auto role = value.at("hello").get<std::string>();
    if (role != "worker" && role != "status") throw std::invalid_argument("hello: must be worker or status");
    if (value.at("version").get<int>() != protocolVersion)
      throw std::invalid_argument("hello: the server speaks version " + std::to_string(protocolVersion));
    hello.role = role == "worker" ? Hello::Role::worker : Hello::Role::status;
    hello.name = printable(value.value("name", ""));
    hello.token = value.value("token", "");
    return hello;
  });
}

Answer readAnswer(std::string_view line) {
  return parsed(line, "answer", [](const json& value) {
    Answer answer;
    answer.number = value.at("answer").get<std::int64_t>();
    const json& costs = value.at("costs");
    if (!costs.is_array() || costs.size() > Search::mostRuns)
      throw std::invalid_argument("answer: costs is no list of at most " + std::to_string(Search::mostRuns));
    for (const json& cost : costs) answer.costs.push_back(toNumber(cost));
    if (!value.contains("figures")) return answer;
    if (value["figures"].size() > maxFigures)
      throw std::invalid_argument("answer: more than " + std::to_string(maxFigures) + " figures");
    for (const auto& [name, figure] : value["figures"].items())
      if (!figure.is_null()) answer.figures[printable(name)] = figure.get<double>();
    return answer;
  });
}

ToWorker readToWorker(std::string_view line) {
  return parsed(line, "the server's line", [](const json& value) {
    ToWorker message;
    message.over = value.value("over", "");
    message.error = value.value("error", "");
    if (value.contains("task")) {
      Welcome& welcome = message.welcome.emplace();
      welcome.task = value.at("task").get<std::string>();
      welcome.options = value.at("options").get<std::map<std::string, std::string>>();
      welcome.parameters = value.at("parameters").get<std::int64_t>();
    }
    if (value.contains("evaluate")) {
      Trial& trial = message.trial.emplace();
      trial.number = value.at("evaluate").get<std::int64_t>();
      const auto parameters = value.at("parameters").get<std::vector<double>>();
      trial.parameters =
          Eigen::Map<const Eigen::VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
      trial.seeds = value.at("seeds").get<std::vector<std::uint64_t>>();
      if (trial.seeds.empty() || trial.seeds.size() > Search::mostRuns)
        throw std::invalid_argument("the server's line: a trial of " + std::to_string(trial.seeds.size()) +
                                    " runs");
    }
    return message;
  });
}

}  // namespace plumbline::farm
