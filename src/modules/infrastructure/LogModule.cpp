#include "modules/infrastructure/LogModule.h"

#include <poll.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/ModuleGraph.h"
#include "framework/PluginModuleBase.h"
#include "framework/SteadyClock.h"

namespace plumbline {

MAKE_SPECIAL_MODULE(log, LogModule)

namespace {

constexpr double nominalCycle = 0.02;  ///< between two runs of a platform's clock [s]

}  // namespace

LogModule::LogModule(const std::string& thread)
    : thread_(thread),
      stop_(ModuleContext::current().stop),
      options_(ModuleContext::current().objects.find<LogOptions>()),
      debug_(ModuleContext::current().objects.find<AgentDebug>()) {}

void LogModule::makePlayer() {
  player_ = std::make_unique<record::ReplayPlayer>(options_->replay->path(), thread_);
  number_ = options_->replay->addPlayer(player_->timestamps());
  if (number_ == 0 && debug_) points_ = std::make_unique<ReplayPoints>(*debug_, *options_->replay);
  if (!options_->notify) return;
  const record::LogReader::Thread& recorded = player_->recorded();
  const std::string warning = "; what modules remember of them is missing";
  if (recorded.cycles.front().number > 1)
    options_->notify(options_->replay->path() + " begins with cycle " +
                     std::to_string(recorded.cycles.front().number) + ", those before are gone" + warning);
  if (const std::uint64_t missing = recorded.missing(); missing > 0)
    options_->notify(options_->replay->path() + ": " + std::to_string(missing) +
                     " cycles are missing in between" + warning);
}

void LogModule::provide(const RepresentationLoader& loader, Representation& target) {
  if (!options_ || !options_->replay)
    throw ConfigurationError("thread " + thread_ + " wants " + loader.name() +
                             " from a log: start the agent with --replay LOG");
  try {
    if (!player_) makePlayer();
    player_->provide(loader, target);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
  offer(loader, target);
}

void LogModule::offer(const RepresentationLoader& loader, const Representation& value) {
  // A representation writes itself by a method that could also read, so it is not const.
  values_.push_back({&loader, &const_cast<Representation&>(value)});
  if (loader.name() == FrameInfo::representationName()) frame_ = static_cast<const FrameInfo*>(&value);
}

void LogModule::planned(const ThreadPlan& plan) {
  if (player_) player_->plan(plan);
  if (!options_ || !options_->recorder) return;
  record::RecordedThread thread{plan.name, {}, {}};
  for (const ModulePlan& module : plan.modules) {
    const std::string& name = module.loader->description().name;
    thread.steps.push_back(name + ":execute");
    for (const ModuleOutput* output : module.outputs)
      thread.steps.push_back(name + ":update" + output->representation->name());
  }
  std::vector<Representation*> values;
  for (const Value& value : values_) {
    const std::string& name = value.loader->name();
    const auto& wanted = options_->representations;
    if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
    thread.topics.push_back({name, plan.provider(name), record::schemaOf(*value.loader)});
    values.push_back(value.value);
  }
  if (!values.empty()) recorder_ = &options_->recorder->addThread(std::move(thread), std::move(values));
}

SpecialModule::Turn LogModule::turn() {
  if (!player_) return Turn::cycle;
  if (points_ && !options_->replay->jumps()) points_->pass();
  const Turn turn = options_->replay->next(number_, player_->played());
  if (turn == Turn::restart) player_->restart();
  return turn;
}

void LogModule::beginCycle() {
  if (player_) player_->begin();
}

void LogModule::beforeModule(std::size_t index) {
  if (player_) player_->beforeModule(index);
}

std::int64_t LogModule::timestamp() {
  double time = frame_ ? frame_->time : steadySeconds();
  time += clockOffset_;
  const double last = 1e-9 * static_cast<double>(lastTimestamp_);
  // A platform that was restarted counts from the beginning; a log's time goes on.
  if (frame_ && lastTimestamp_ >= 0 && time < last) {
    clockOffset_ += last - time + nominalCycle;
    time = last + nominalCycle;
  }
  lastTimestamp_ = static_cast<std::int64_t>(std::llround(1e9 * std::clamp(time, 0.0, 9e9)));
  return lastTimestamp_;
}

void LogModule::endCycle() {
  if (player_) player_->end();
  if (recorder_) recorder_->record(timestamp());
  if (!player_ || !options_->replay->played(number_, player_->played())) {
    if (!player_ || !player_->atEnd() || options_->replay->stays()) return;
    // Other threads are not at their end yet; without another cycle here.
    pollfd stopped{stop_.fileDescriptor(), POLLIN, 0};
    poll(&stopped, 1, -1);
    return;
  }
  stop_.request(0, "the log has ended");
}

}  // namespace plumbline
