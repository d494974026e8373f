// bin/gap report: an answer as a page for people.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "framework/WriteFile.h"
#include "gap/report/AnswerFile.h"
#include "gap/report/ReportPage.h"
#include "main/gap/Commands.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

namespace {

struct ReportOptions {
  std::string answer, robot, check, output = "report.html";
};

void report(const ReportOptions& options) {
  nlohmann::json answer = readAnswer(options.answer);
  if (!options.check.empty()) answer["check"] = readCheck(options.check);
  std::optional<Mechanism> robot;
  if (!options.robot.empty()) {
    robot = namedMechanism(options.robot);
  } else if (const std::string name =
                 answer.value("robot", nlohmann::json("")).is_string() ? answer.value("robot", "") : "";
             !name.empty()) {
    try {
      robot = findMechanism(name);
    } catch (const MechanismError&) {
      std::printf("Without a figure of %s, which is not in config/robots: --robot FILE shows it\n",
                  name.c_str());
    }
  }
  writeFile(options.output, reportPage(builtReportPage(), answer, robot));
  std::printf("Written to %s; open it in a browser\n", options.output.c_str());
}

}  // namespace

void addReport(CommandLine& app) {
  auto options = std::make_shared<ReportOptions>();
  CommandLine command = app.command("report", "Makes a page for people from an answer");
  command.option("answer", options->answer, "The file that bin/gap diagnose --json wrote").required();
  command.option("-o,--output", options->output, "The page, one HTML file").showDefault();
  command.option("--robot", options->robot, "URDF or JSON file, for the figure [the answer's robot]");
  command.option(
      "--check", options->check,
      "Shows what the answer closed of other recordings: the file that bin/gap check --json wrote");
  command.footer(
      "Examples:\n  bin/gap report answer.json -o report.html\n"
      "  bin/gap check answer.json other_runs --json check.json && bin/gap report answer.json --check "
      "check.json");
  command.whenChosen([options] { report(*options); });
}

}  // namespace plumbline::gap
