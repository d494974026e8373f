#pragma once
#include "framework/Module.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/infrastructure/ServerMessageText.h"
#include "representations/infrastructure/SimSparkInfo.h"
#include "representations/perception/HearPercept.h"
#include "representations/perception/PolarPercepts.h"
#include "simspark/ServerMessage.h"
#include "simspark/ServerMessageParser.h"

namespace plumbline {

MODULE(Parser)
  REQUIRES(ServerMessageText)
  REQUIRES_IF_PROVIDED(SimSparkInfo)
  PROVIDES(FrameInfo)
  PROVIDES(GameState)
  PROVIDES(PlayerInfo)
  PROVIDES(JointData)
  PROVIDES(SensorData)
  PROVIDES(VisionInfo)
  PROVIDES(PolarBallPercept)
  PROVIDES(PolarLandmarkPercept)
  PROVIDES(PolarLinePercept)
  PROVIDES(PolarPlayerPercept)
  PROVIDES(HearPercept)
  PROVIDES(GroundTruth)
END_MODULE

/// Reads the simulator's message. If a message cannot be read to its end, nothing of it is used: it is
/// logged, measured values stay unchanged, and there is no image and no heard message in that cycle. If a
/// single percept is beyond its limits (simspark/PerceptLimits.h), only that one is left out.
class Parser : public ParserBase {
public:
  void init() override;
  void execute() override;
  void update(FrameInfo* theFrameInfo) override;
  void update(GameState* theGameState) override;
  void update(PlayerInfo* thePlayerInfo) override;
  void update(JointData* theJointData) override;
  void update(SensorData* theSensorData) override;
  void update(VisionInfo* theVisionInfo) override;
  void update(PolarBallPercept* thePolarBallPercept) override;
  void update(PolarLandmarkPercept* thePolarLandmarkPercept) override;
  void update(PolarLinePercept* thePolarLinePercept) override;
  void update(PolarPlayerPercept* thePolarPlayerPercept) override;
  void update(HearPercept* theHearPercept) override;
  void update(GroundTruth* theGroundTruth) override;

private:
  simspark::ServerMessageParser parser_;
  simspark::ServerMessage message_;  ///< the last one that could be read
  simspark::ServerMessage next_;
  bool started_ = false;
  bool readable_ = false;  ///< this cycle's message could be read
  unsigned dropped_ = 0;   ///< percepts beyond what can be measured, so far
  PlayerInfo player_;
  double time_ = 0, cycleSeconds_ = 0;  ///< [s]
  unsigned cycle_ = 0;
  int connections_ = 0;
  bool restarted_ = false;
};

/// The referee's play mode ("KickOff_Left", ...) as the team on that side sees it; unknown for a word that is
/// none.
TeamPlayMode playModeOf(const std::string& word, bool leftSide);

}  // namespace plumbline
