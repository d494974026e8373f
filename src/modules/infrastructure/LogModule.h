#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "framework/SpecialModule.h"
#include "framework/StopSignal.h"
#include "modules/infrastructure/LogOptions.h"
#include "modules/infrastructure/ReplayPoints.h"
#include "record/Recorder.h"
#include "record/ReplayPlayer.h"
#include "representations/infrastructure/FrameInfo.h"

namespace plumbline {

/// The special module `log`. A line `log` records the thread's representations when the agent has a recorder
/// (`--log`); lines `log BallPos` provide what a log holds (`--replay`). Without either it does nothing.
class LogModule : public SpecialModule {
public:
  explicit LogModule(const std::string& thread);

  void provide(const RepresentationLoader& loader, Representation& target) override;
  void offer(const RepresentationLoader& loader, const Representation& value) override;
  void planned(const ThreadPlan& plan) override;
  Turn turn() override;
  void beginCycle() override;
  void beforeModule(std::size_t index) override;
  void endCycle() override;

private:
  struct Value {
    const RepresentationLoader* loader;
    Representation* value;
  };
  void makePlayer();
  void record();
  std::int64_t timestamp();

  std::string thread_;
  StopSignal& stop_;
  const LogOptions* options_;
  AgentDebug* debug_;
  std::unique_ptr<record::ReplayPlayer> player_;
  std::size_t number_ = 0;  ///< of the player
  std::unique_ptr<ReplayPoints> points_;
  record::ThreadRecorder* recorder_ = nullptr;
  std::vector<Value> values_;
  const FrameInfo* frame_ = nullptr;
  double clockOffset_ = 0;
  std::int64_t lastTimestamp_ = -1;
};

}  // namespace plumbline
