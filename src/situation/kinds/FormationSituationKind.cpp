#include "situation/kinds/FormationSituationKind.h"

#include <fmt/format.h>

#include "representations/behavior/PlayerRole.h"
#include "representations/communication/TeamReports.h"
#include "situation/CycleOfLog.h"
#include "situation/Rounded.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

Vec2 middleOf(const std::array<double, 4>& area) {
  return {(area[0] + area[1]) / 2, (area[2] + area[3]) / 2};
}

class FormationSituationKind : public SituationKind {
public:
  FormationSituationKind()
      : SituationKind({.name = "formation",
                       .order = 30,
                       .heading = "The formation: who goes to the ball, and who goes where",
                       .knowsMode = true,
                       .hasRobot = false}) {}

  /// The player's own place is among those of the team.
  void read(const ConfigSection& root, Situation& situation) const override {
    situation.player = root.get<int>("player", 1, teamSize);
    bool found = false;
    for (const auto& row : readRows(root, "team", 5, 5, "[number, x, y, heading, seconds to the ball]")) {
      const SaidPlace said{playerNumber(root, "team", row[0]), Pose2(row[1], row[2], row[3]), row[4]};
      if (said.timeToBall < 0) root.fail("team", fmt::format("must not have {:g} s to the ball", row[4]));
      situation.team.push_back(said);
      if (said.number != situation.player) continue;
      situation.robot = said.pose;
      found = true;
    }
    if (!found)
      root.fail("player",
                fmt::format("must be one of the team's, not {}: its place is there", situation.player));
  }

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    auto expected = std::make_shared<FormationExpected>();
    expected->striker = section.get<int>("striker", SituationLimits::numbers());
    expected->role = readChoice<FormationExpected::Role>(section, "role", FormationExpected::roleNames);
    expected->area = section.find<std::array<double, 4>>("area", SituationLimits::places());
    if (const auto& area = expected->area; area && ((*area)[0] > (*area)[1] || (*area)[2] > (*area)[3]))
      section.fail("area", "must be [x from, x to, y from, y to] with the smaller one of each first");
    return expected;
  }

  KindText text(const Situation& situation) const override {
    std::string text =
        fmt::format("player: {}\nteam:  # number, x, y, heading, seconds to the ball\n", situation.player);
    for (const SaidPlace& said : situation.team)
      text += fmt::format("  - [{}, {}, {}, {}]\n", said.number, rounded(said.pose.position),
                          rounded(said.pose.heading), rounded(said.timeToBall));
    return {.beforeBall = text};
  }

  void take(const CycleOfLog& cycle, Situation& situation) const override {
    const TeamRobotPose team = cycle.get<TeamRobotPose>();
    for (const TeamReport& report : team.reports)
      if (report.belief.localised && report.belief.number != situation.player)
        situation.team.push_back({report.belief.number, report.belief.pose, report.belief.timeToBall});
    situation.team.push_back({situation.player, situation.robot, cycle.get<PlayerRole>().timeToBall});
  }
};

MAKE_SITUATION_KIND(FormationSituationKind)

}  // namespace

std::string FormationExpected::text() const {
  return fmt::format("{{striker: {}, role: {}{}}}", striker, roleNames.at(static_cast<std::size_t>(role)),
                     area ? ", area: [" + rounded(*area) + "]" : "");
}

std::string FormationExpected::words(int player) const {
  std::string words = fmt::format("number {} goes to the ball", striker);
  if (role == Role::striker) return words;
  words += fmt::format("; number {} is {}", player, role == Role::goalie ? "the goalie" : "a supporter");
  if (area) {
    const auto& a = *area;
    words +=
        fmt::format(" at x {} to {}, y {} to {}", rounded(a[0]), rounded(a[1]), rounded(a[2]), rounded(a[3]));
  }
  return words;
}

std::vector<Vec2> FormationExpected::places(const Situation&, const FieldSize&) const {
  if (!area) return {};
  return {Vec2((*area)[0], (*area)[2]), Vec2((*area)[1], (*area)[3])};
}

void FormationExpected::draw(const Situation& s, const FieldSize&, SituationCanvas& canvas) const {
  for (const SaidPlace& said : s.team)
    if (said.number == striker) {
      canvas.arrow(said.pose.position, s.ball);
      canvas.label(said.pose.position, "to the ball");
    }
  if (area) {
    canvas.area({(*area)[0], (*area)[2]}, {(*area)[1], (*area)[3]});
    canvas.arrow(s.robot.position, middleOf(*area));
  }
  if (role != Role::striker)
    canvas.label(area ? middleOf(*area) : s.robot.position, role == Role::goalie ? "goalie" : "supporter");
}

}  // namespace plumbline
