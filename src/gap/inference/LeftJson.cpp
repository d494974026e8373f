#include "gap/inference/LeftJson.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace plumbline::gap {

namespace {

using nlohmann::json;

json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

std::string unitOf(const std::string& signal) {
  const std::string kind = signal.substr(0, signal.find('.'));
  if (kind == "pos") return "rad";
  if (kind == "vel" || kind == "gyro") return "rad/s";
  if (kind == "torque") return "N m";
  if (kind == "current") return "A";
  if (kind == "acc") return "m/s^2";
  if (kind == "fsr") return "N";
  return kind == "duty" ? "1" : "";
}

constexpr std::size_t fewJoints = 3;  // that are all listed, gap or not

json figures(double before, double after, double floor, bool hasFloor) {
  return {{"before", number(before)}, {"after", number(after)}, {"floor", hasFloor ? number(floor) : json()}};
}

}  // namespace

json leftJson(const RecordingLeft& left) {
  json j = figures(left.before, left.after, left.floor, left.hasFloor);
  j["folder"] = left.folder;
  j["closed"] = number(left.closed());
  j["noise"] = number(left.noise);
  j["closed_to_noise"] = number(left.closedToNoise());
  if (left.fellBefore || left.fellAfter) j["fell"] = {{"before", left.fellBefore}, {"after", left.fellAfter}};
  j["signals"] = json::object();
  for (const SignalLeft& signal : left.signals) {
    json of = figures(signal.before, signal.after, signal.floor, signal.hasFloor);
    of["unit"] = unitOf(signal.signal);
    j["signals"][signal.signal] = of;
  }
  return j;
}

json checkJson(const std::vector<RecordingLeft>& recordings) {
  json j;
  j["runs"] = json::array();
  double before = 0, after = 0;
  const auto n = static_cast<double>(std::max<std::size_t>(1, recordings.size()));
  for (const RecordingLeft& left : recordings) {
    j["runs"].push_back(leftJson(left));
    before += left.before * left.before / n;
    after += left.after * left.after / n;
  }
  j["before"] = number(std::sqrt(before));
  j["after"] = number(std::sqrt(after));
  j["closed"] = number(meanClosed(recordings));
  j["closed_to_noise"] = number(meanClosedToNoise(recordings));
  return j;
}

std::string leftTable(const std::vector<RecordingLeft>& recordings) {
  std::string text =
      "  recording                              signal            before   after   floor  closed\n";
  const auto line = [&text](const std::string& folder, const std::string& signal, double before, double after,
                            double floor, bool hasFloor, double noise) {
    char buffer[256], least[32];
    const double base = std::max(floor, noise);
    std::snprintf(least, sizeof least, "%s%.1f", hasFloor && floor >= noise ? "" : "~", 1e3 * base);
    std::snprintf(buffer, sizeof buffer, "  %-38.38s %-15.15s %8.1f %7.1f %7s %5.0f %%\n", folder.c_str(),
                  signal.c_str(), 1e3 * before, 1e3 * after, least,
                  before > base ? 100 * std::min(1.0, (before - after) / (before - base)) : 0);
    text += buffer;
  };
  for (const RecordingLeft& left : recordings) {
    const std::string folder =
        left.folder.size() > 38 ? "..." + left.folder.substr(left.folder.size() - 35) : left.folder;
    line(folder, "positions", left.before, left.after, left.floor, left.hasFloor, left.noise);
    std::size_t positions = 0;
    for (const SignalLeft& signal : left.signals) positions += signal.position;
    for (const SignalLeft& signal : left.signals)
      if (signal.position && positions > 1 && (signal.showsGap() || positions <= fewJoints))
        line("", signal.signal, signal.before, signal.after, signal.floor, signal.hasFloor, signal.noise);
  }
  return text +
         "  (mrad, or mm for sliding joints; floor: what repeats differ by, or ~ the noise of the "
         "readings)\n";
}

}  // namespace plumbline::gap
