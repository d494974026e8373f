#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plumbline::bench {

/// Mean of independent runs with the half width of its 95 % interval (Student's t).
struct Estimate {
  double mean = 0, half = 0;
  std::size_t runs = 0;
};
Estimate estimate(const std::vector<double>& runs);
/// "1.02 ± 0.03" with so many digits after the point.
std::string text(const Estimate& value, int digits = 2);

/// Figures for build/bench/walking.json and tables for build/bench/walking.md.
class Report {
public:
  struct Target {
    bool higher = true;
    double value = 0;
  };
  void figure(const std::string& name, double value, const std::string& unit, const Target& target,
              const std::string& peer = "", double peerValue = 0);
  /// A heading, a paragraph or a table's row.
  void heading(const std::string& line) { markdown_ += "\n## " + line + "\n\n"; }
  void paragraph(const std::string& line) { markdown_ += line + "\n\n"; }
  void tableHead(const std::vector<std::string>& cells);
  void row(const std::vector<std::string>& cells);

  /// What another report has, after what this one has.
  void append(const Report& part);

  const std::string& tables() const { return markdown_; }
  std::string json() const;

  /// Puts it away in a file, beside its place first; throws std::runtime_error.
  void keep(const std::string& path) const;
  /// One that was put away, which it prints; nothing where there is none.
  static std::optional<Report> kept(const std::string& path);

private:
  std::string markdown_;
  std::vector<std::string> figures_;
};

}  // namespace plumbline::bench
