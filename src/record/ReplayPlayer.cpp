#include "record/ReplayPlayer.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "framework/ModuleGraph.h"
#include "framework/NearestName.h"
#include "record/CdrStream.h"

namespace plumbline::record {
namespace {

constexpr std::size_t behindAll = std::numeric_limits<std::size_t>::max();

const LogReader::Thread& threadOf(const LogReader& reader, const std::string& name) {
  const auto& threads = reader.threads();
  return threads.size() == 1 ? threads.front() : reader.thread(name);
}

/// The place of a step in the recorded cycle.
std::size_t placeOf(const std::vector<std::string>& steps, const std::string& label) {
  const auto found = std::ranges::find(steps, label);
  return found == steps.end() ? behindAll : static_cast<std::size_t>(found - steps.begin());
}

}  // namespace

ReplayPlayer::ReplayPlayer(const std::string& path, const std::string& thread)
    : reader_(path), thread_(threadOf(reader_, thread)), topics_(thread_.recorded.topics.size()) {
  if (thread_.cycles.empty())
    throw std::runtime_error(path + ": no cycle of thread " + thread_.recorded.name);
}

void ReplayPlayer::provide(const RepresentationLoader& loader, Representation& target) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const RecordedTopic& topic = thread_.recorded.topics[i];
    names.push_back(topic.representation);
    if (topic.representation != loader.name()) continue;
    const Schema now = schemaOf(loader);
    if (now != topic.schema)
      throw std::runtime_error(
          reader_.path() + ": " + loader.name() + " had other members when it was recorded: " +
          schemaText(topic.schema).substr(0, 200) + ", now " + schemaText(now).substr(0, 200));
    topics_[i].target = &target;
    return;
  }
  throw std::runtime_error(reader_.path() + " has no " + loader.name() + suggestion(loader.name(), names));
}

void ReplayPlayer::plan(const ThreadPlan& plan) {
  const std::vector<std::string>& steps = thread_.recorded.steps;
  late_.clear();
  std::vector<std::vector<std::size_t>> late(plan.modules.size() + 1);
  bool any = false;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const RecordedTopic& topic = thread_.recorded.topics[i];
    if (!topics_[i].target) continue;
    const std::size_t updated = placeOf(steps, topic.provider + ":update" + topic.representation);
    if (updated == behindAll) continue;  // it was there when the cycle began
    std::size_t before = 0;
    for (std::size_t m = 0; m < plan.modules.size(); ++m) {
      const ModulePlan& module = plan.modules[m];
      const auto input = std::ranges::find(module.inputs, topic.representation, &ModuleInput::representation);
      if (input == module.inputs.end()) continue;
      if (input->kind != ModuleInput::Kind::used) break;
      if (placeOf(steps, module.loader->description().name + ":execute") > updated) break;
      before = m + 1;  // this one saw the value of the cycle before
    }
    if (before == 0) continue;
    topics_[i].late = any = true;
    late[before].push_back(i);
  }
  if (any) late_ = std::move(late);
}

std::vector<std::int64_t> ReplayPlayer::timestamps() const {
  std::vector<std::int64_t> result;
  for (const LogReader::Cycle& cycle : thread_.cycles) result.push_back(cycle.timestamp);
  return result;
}

void ReplayPlayer::apply(std::size_t index, std::string_view message) {
  const RecordedTopic& topic = thread_.recorded.topics[index];
  if (topic.schema.parts.empty()) return;  // nothing is in it
  CdrInStream in(message);
  topics_[index].target->stream(&in, nullptr);
  if (in.ok() && !in.atEnd()) in.fail("bytes left over");
  if (!in.ok())
    throw std::runtime_error(reader_.path() + ": cycle " + std::to_string(thread_.cycles[played_].number) +
                             ", " + topic.representation + ": " + in.error());
}

void ReplayPlayer::begin() {
  reader_.read(thread_, thread_.cycles[played_], [this](std::size_t index, std::string_view message) {
    Topic& topic = topics_[index];
    if (!topic.target) return;
    if (!topic.late) return apply(index, message);
    topic.waiting.assign(message);
    topic.waits = true;
  });
}

void ReplayPlayer::applyWaiting(std::size_t index) {
  Topic& topic = topics_[index];
  if (!topic.waits) return;
  topic.waits = false;
  apply(index, topic.waiting);
}

void ReplayPlayer::applyBefore(std::size_t index) {
  for (const std::size_t topic : late_[index]) applyWaiting(topic);
}

void ReplayPlayer::end() {
  if (!late_.empty()) applyBefore(late_.size() - 1);
  played_++;
}

}  // namespace plumbline::record
