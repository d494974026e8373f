#include "bench/walking/Report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/WriteFile.h"

namespace plumbline::bench {

Estimate estimate(const std::vector<double>& runs) {
  Estimate e;
  e.runs = runs.size();
  if (runs.empty()) return e;
  for (const double run : runs) e.mean += run / static_cast<double>(runs.size());
  if (runs.size() < 2) return e;
  double squares = 0;
  for (const double run : runs) squares += (run - e.mean) * (run - e.mean);
  constexpr double t[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36,
                          2.31,  2.26, 2.23, 2.20, 2.18, 2.16, 2.14};
  const std::size_t freedom = runs.size() - 1;
  const double quantile =
      freedom <= std::size(t) ? t[freedom - 1] : 1.96 + 2.5 / static_cast<double>(freedom);
  e.half = quantile * std::sqrt(squares / static_cast<double>(freedom * runs.size()));
  return e;
}

std::string text(const Estimate& value, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", value.mean, digits, value.half, digits);
}

void Report::figure(const std::string& name, double value, const std::string& unit, const Target& target,
                    const std::string& peer, double peerValue) {
  std::string line = fmt::format(R"({{"name": "walking.{}", "value": {:.6g}, "unit": "{}", "better": "{}")",
                                 name, value, unit, target.higher ? "higher" : "lower");
  if (std::isfinite(target.value)) line += fmt::format(R"(, "target": {:.6g})", target.value);
  if (!peer.empty()) line += fmt::format(R"(, "peer": "{}", "peer_value": {:.6g})", peer, peerValue);
  figures_.push_back(line + "}");
}

void Report::append(const Report& part) {
  markdown_ += part.markdown_;
  figures_.insert(figures_.end(), part.figures_.begin(), part.figures_.end());
}

std::string Report::json() const { return fmt::format("[\n  {}\n]\n", fmt::join(figures_, ",\n  ")); }

void Report::keep(const std::string& path) const {
  writeFile(path, nlohmann::json{{"tables", markdown_}, {"figures", figures_}}.dump(1) + "\n");
}

std::optional<Report> Report::kept(const std::string& path) {
  std::ifstream file(path);
  if (!file) return {};
  const nlohmann::json json = nlohmann::json::parse(file);
  Report report;
  report.markdown_ = json.at("tables");
  report.figures_ = json.at("figures");
  std::fputs(report.markdown_.c_str(), stdout);
  std::fflush(stdout);
  return report;
}

void Report::tableHead(const std::vector<std::string>& cells) {
  row(cells);
  markdown_ += "|";
  for (std::size_t i = 0; i < cells.size(); ++i) markdown_ += "---|";
  markdown_ += "\n";
}

void Report::row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  markdown_ += line + "\n";
  std::puts(line.c_str());
  std::fflush(stdout);
}

}  // namespace plumbline::bench
