#include "gap/report/ReportPage.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/ReadFile.h"
#include "gap/effects/Effects.h"
#include "gap/record/Postures.h"
#include "simspark/ChildProcess.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr std::size_t maxPage = std::size_t{64} << 20;  // [bytes]

json point(const Vec3& p) {
  const auto rounded = [](double x) { return std::round(1e4 * x) / 1e4; };
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

/// Where the joints are, in the base's frame, in the posture that the robot hangs in.
json figureOf(const Mechanism& robot) {
  std::vector<double> posture = neutralPosture(robot);
  try {
    posture = namedPosture("hang", robot).value_or(posture);
  } catch (const std::exception&) {
    // A broken file of postures costs the figure its posture, not the report.
  }
  const std::vector<Pose3> poses = linkPoses(robot, posture);
  std::vector<bool> leaf(robot.links.size(), true);
  for (const auto& joint : robot.joints) leaf[static_cast<std::size_t>(joint.parent)] = false;
  json figure;
  figure["base"] = point(robot.links.front().com);
  figure["joints"] = json::array();
  for (const auto& joint : robot.joints) {
    const auto child = static_cast<std::size_t>(joint.child);
    // Joint i moves link i + 1.
    figure["joints"].push_back({{"name", joint.name},
                                {"parent", joint.parent - 1},
                                {"p", point(poses[child].translation())},
                                {"end", point(poses[child] * (2 * robot.links[child].com))},
                                {"leaf", static_cast<bool>(leaf[child])}});
  }
  if (robot.hasImu)
    figure["imu"] = point(poses[static_cast<std::size_t>(robot.imu.link)] * robot.imu.accelerometer);
  figure["feet"] = json::array();
  for (const auto& foot : robot.feet)
    figure["feet"].push_back(
        {{"name", foot.name}, {"p", point(poses[static_cast<std::size_t>(foot.link)] * foot.soleCentre)}});
  return figure;
}

}  // namespace

std::string reportPage(const std::string& builtPage, json answer, const std::optional<Mechanism>& robot) {
  if (robot) answer["figure"] = figureOf(*robot);
  for (json& cause : answer["effects"]) {
    const Effect* effect = findEffect(cause["effect"].get<std::string>());
    if (!effect) continue;
    // A limit that is not there has no nominal value that a scale could show.
    if (!effect->nominalIsNone) cause["nominal"] = effect->nominal;
    if (!cause.contains("unit")) cause["unit"] = effect->unit;
  }
  constexpr std::string_view mark = "/*ANSWER*/";
  const std::size_t at = builtPage.find(mark);
  if (at == std::string::npos)
    throw std::runtime_error("build/report/page.html is broken: run `make web` again");
  // Within a script, < could begin the script's end.
  std::string text;
  for (const char c : answer.dump(-1, ' ', true, json::error_handler_t::replace))
    c == '<' ? text += "\\u003c" : text += c;
  return builtPage.substr(0, at) + text + builtPage.substr(at + mark.size());
}

std::string builtReportPage() {
  const std::string programs = programFolder();
  for (const char* place : {"/../build/report/page.html", "/../../report/page.html"}) {
    if (std::filesystem::exists(programs + place)) return readFile(programs + place, maxPage);
  }
  throw std::runtime_error("the report's page is not built: run `make web` once");
}

}  // namespace plumbline::gap
