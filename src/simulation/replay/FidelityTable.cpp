#include "simulation/replay/FidelityTable.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"
#include "simulation/replay/BallStart.h"
#include "simulation/replay/Fidelity.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;
using Rows = std::vector<TraceRow>;

constexpr double withinMillimetre = 1;  // [mm]
constexpr FidelityTarget within2Percent{{}, 0.02}, within5Percent{{}, 0.05}, withinPerMille{{}, 0.001};

class Lines {
public:
  Lines(const LeagueTrace& trace, const Rows& ours, const LeagueSpread& spread)
      : trace(trace), ours(ours), spread_(spread), all_(figures(trace.rows, ours)) {}

  /// A figure of Fidelity.h by its name there, if the trace has it.
  void figure(const std::string& name, FidelityTarget target, double scale = 1, const char* unit = nullptr) {
    for (const TraceFigure& f : all_)
      if (f.name == name) value(name, unit ? unit : f.unit, scale * f.league, scale * f.ours, target);
  }
  void value(const std::string& name, const std::string& unit, double league, double our,
             FidelityTarget target) {
    FidelityLine line{trace.name, name, unit, league, our, our - league, spreadOf(name), target};
    if (std::isnan(line.difference)) line.difference = std::isnan(league) == std::isnan(our) ? 0 : INFINITY;
    lines.push_back(line);
  }
  void deviation(const std::string& name, const std::string& unit, double size, FidelityTarget target) {
    lines.push_back({trace.name, name, unit, {}, {}, size, spreadOf(name), target});
  }
  /// A figure of gaits: 2 % where the server itself is as near.
  void gait(const std::string& name) {
    figure(name, within2Percent);
    FidelityLine& line = lines.back();
    if (line.figure == name && line.spread && *line.spread > *line.allowed()) line.target = {};
  }

  const LeagueTrace& trace;
  const Rows& ours;
  std::vector<FidelityLine> lines;

private:
  std::optional<double> spreadOf(const std::string& figure) const {
    const auto found = spread_.find(figure);
    return found == spread_.end() ? std::nullopt : std::optional(found->second);
  }
  const LeagueSpread& spread_;
  std::vector<TraceFigure> all_;
};

double worstJointAt(const TraceRow& a, const TraceRow& b) {
  double worst = 0;
  for (std::size_t j = 0; j < maxJoints; ++j) worst = std::max(worst, std::abs(a.angle[j] - b.angle[j]));
  return toDegrees(worst);
}

std::size_t lowestRow(const Rows& rows) {
  const auto lowest = std::min_element(rows.begin(), rows.end(), [](const TraceRow& a, const TraceRow& b) {
    return a.torso.translation().z() < b.torso.translation().z();
  });
  return static_cast<std::size_t>(lowest - rows.begin());
}

Vec3 ballVelocity(const Rows& rows, std::size_t row) {
  return (rows[row].ball - rows[row - 1].ball) / traceStep;
}

/// The row of the league's that changes the ball's horizontal velocity most.
std::size_t hitRow(const LeagueTrace& trace) {
  std::size_t hit = 2;
  double most = 0;
  for (std::size_t i = 2; i < trace.rows.size(); ++i) {
    if (ballJumps(trace, i) || ballJumps(trace, i - 1)) continue;
    const Vec3 change = ballVelocity(trace.rows, i) - ballVelocity(trace.rows, i - 1);
    if (const double size = change.head<2>().norm(); size > most) {
      most = size;
      hit = i;
    }
  }
  return hit;
}

/// Heights between bounces, of the ball's centre.
std::vector<double> apexes(const Rows& rows) {
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    if (rows[i].ball.z() > rows[i - 1].ball.z() && rows[i].ball.z() >= rows[i + 1].ball.z() &&
        rows[i].ball.z() > 0.06)
      found.push_back(rows[i].ball.z());
  return found;
}

void standing(Lines& t) {
  t.figure("torso height, last", {withinMillimetre, {}}, 1000, "mm");
  t.deviation("torso, largest deviation", "mm", 1000 * deviation(t.trace.rows, t.ours).position, {});
}

void crouching(Lines& t) {
  const std::size_t bottom = lowestRow(t.trace.rows);
  t.value("torso height, bottom", "mm", 1000 * t.trace.rows[bottom].torso.translation().z(),
          1000 * t.ours[bottom].torso.translation().z(), {withinMillimetre, {}});
  t.deviation("worst joint, bottom", "deg", worstJointAt(t.trace.rows[bottom], t.ours[bottom]), {0.1, {}});
}

void swinging(Lines& t) {
  t.deviation("worst joint", "deg", toDegrees(deviation(t.trace.rows, t.ours).angle), {});
  t.deviation("torso, largest deviation", "mm", 1000 * deviation(t.trace.rows, t.ours).position, {});
}

void falling(Lines& t) {
  t.figure("leans by 45 deg at", {1e-9, {}});
  t.figure("leans by 60 deg at", {1e-9, {}});
  t.figure("torso height, last", {withinMillimetre, {}}, 1000, "mm");
}

void gaiting(Lines& t, bool turning) {
  const TraceDeviation d = deviation(t.trace.rows, t.ours);
  t.deviation("torso, first 2 s", "mm", 1000 * d.position2s, {2.0, {}});
  t.deviation("torso turned, first 2 s", "deg", toDegrees(d.rotation2s), {0.2, {}});
  if (!turning) t.gait("speed, last 5 s");
  if (!turning) t.gait("sway, last 5 s");
  t.gait("turn rate, last 5 s");
  t.deviation("torso, at the end", "mm", 1000 * d.positionAtEnd, {});
}

void gettingUp(Lines& t) {
  t.deviation("torso, at the end", "mm", 1000 * deviation(t.trace.rows, t.ours).positionAtEnd, {20.0, {}});
  t.figure("torso up-axis z, last", {0.02, {}});
}

void kicking(Lines& t) {
  t.figure("ball, fastest", within5Percent);
  t.figure("ball, distance", within5Percent);
  t.figure("ball, highest", {});
}

void onFoot(Lines& t) {
  const std::size_t after = std::min(hitRow(t.trace) + 1, t.ours.size() - 1);
  t.value("ball, speed after the foot", "m/s", ballVelocity(t.trace.rows, after).head<2>().norm(),
          ballVelocity(t.ours, after).head<2>().norm(), within5Percent);
  t.deviation("ball, largest deviation", "mm", 1000 * deviation(t.trace.rows, t.ours).ball, {});
}

void ballAlone(Lines& t) {
  t.figure("ball, distance", withinPerMille);
  const std::vector<double> league = apexes(t.trace.rows), ours = apexes(t.ours);
  for (std::size_t i = 0; i < league.size(); ++i)
    t.value("ball, height " + std::to_string(i + 1), "m", league[i], i < ours.size() ? ours[i] : 0,
            withinPerMille);
}

}  // namespace

std::optional<double> FidelityLine::allowed() const {
  if (target.absolute) return target.absolute;
  if (target.relative && league) return *target.relative * std::abs(*league);
  return std::nullopt;
}

bool FidelityLine::met() const { return !allowed() || std::abs(difference) <= *allowed(); }

std::vector<FidelityLine> fidelityLines(const LeagueTrace& trace, const Rows& ours,
                                        const LeagueSpread& spread) {
  Lines lines(trace, ours, spread);
  const auto is = [&](const char* prefix) { return trace.name.starts_with(prefix); };
  if (is("stand")) standing(lines);
  if (is("crouch")) crouching(lines);
  if (is("swing")) swinging(lines);
  if (is("fall")) falling(lines);
  if (is("ut_walk") || is("ut_turn")) gaiting(lines, is("ut_turn"));
  if (is("ut_getup")) gettingUp(lines);
  if (is("ut_kick")) kicking(lines);
  if (is("ballfoot")) onFoot(lines);
  if (is("ball_")) ballAlone(lines);
  return lines.lines;
}

LeagueSpread leagueSpread(const LeagueTrace& trace, const LeagueTrace& again) {
  LeagueSpread spread;
  for (const FidelityLine& line : fidelityLines(trace, again.rows, {}))
    spread[line.figure] = std::abs(line.difference);
  return spread;
}

}  // namespace plumbline::simulation
