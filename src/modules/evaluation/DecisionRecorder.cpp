#include "modules/evaluation/DecisionRecorder.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "modules/evaluation/OutputProblems.h"

namespace plumbline {

MAKE_MODULE(DecisionRecorder)

namespace {

std::string columnNames() {
  std::string names = "clock,x,y";
  for (std::size_t i = 1; i <= StrikerDecision::maxOptions; ++i)
    names += fmt::format(",action{0},endX{0},endY{0},value{0},goal{0}", i);
  return names;
}

double directionOf(const StrikerDecision& decision) {
  const Vec2 way = decision.options.front().end - decision.ball;
  return std::atan2(way.y(), way.x());
}

}  // namespace

DecisionRecorder::DecisionRecorder() : file_("the decisions", columnNames()) {}

void DecisionRecorder::init() {
  const DecisionOptions* options = findObject<DecisionOptions>();
  folder_ = options ? options->folder : "";
  if (folder_.empty()) return;
  try {
    PlayerFile::prepare(folder_);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(std::string("--decisions: ") + error.what());
  }
}

bool DecisionRecorder::due() const {
  const double passed = theFrameInfo->time - written_;
  if (passed < 0 || passed >= again) return true;  // the platform's clock was set back
  if (passed < interval) return false;
  const StrikerDecision& now = *theStrikerDecision;
  return now.options.front().action != action_ ||
         std::abs(normalizeAngle(directionOf(now) - direction_)) > turned;
}

void DecisionRecorder::write() {
  const StrikerDecision& now = *theStrikerDecision;
  std::string line = fmt::format("{:.2f},{:.2f},{:.2f}", theGameState->time, now.ball.x(), now.ball.y());
  for (std::size_t i = 0; i < StrikerDecision::maxOptions; ++i) {
    if (i >= now.options.size()) {
      line += ",,,,,";
      continue;
    }
    const StrikerOption& option = now.options[i];
    line += fmt::format(",{},{:.2f},{:.2f},{:.3f},{:.3f}", option.action, option.end.x(), option.end.y(),
                        option.value, option.goal);
  }
  file_.write(folder_, *thePlayerInfo, line + '\n', object<OutputProblems>());
  ++lines_;
  written_ = theFrameInfo->time;
  action_ = now.options.front().action;
  direction_ = directionOf(now);
}

void DecisionRecorder::execute() {
  if (folder_.empty() || lines_ >= maxLines) return;
  if (!theStrikerDecision->valid || theStrikerDecision->options.empty()) return;
  // The game's clock is stopped until then, so moments could not be distinguished.
  if (theGameState->playMode == TeamPlayMode::beforeKickOff) return;
  // The file is named by both.
  if (!thePlayerInfo->sideKnown || thePlayerInfo->number < 1) return;
  if (due()) write();
}

}  // namespace plumbline
