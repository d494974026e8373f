#include "support/PerceptionModules.h"

#include "framework/Module.h"
#include "representations/infrastructure/ServerMessageText.h"

namespace plumbline {

MODULE(TestServer)
  PROVIDES(ServerMessageText)
END_MODULE

/// Stands for the connection to a simulator.
class TestServer : public TestServerBase {
public:
  void update(ServerMessageText* theServerMessageText) override {
    theServerMessageText->text = object<test::MessageSource>().text;
  }
};

MAKE_MODULE(TestServer)

namespace test {

const char* perceptionModules() {
  return R"(TestServer ServerMessageText
Parser FrameInfo
Parser GameState
Parser PlayerInfo
Parser JointData
Parser SensorData
Parser VisionInfo
Parser PolarBallPercept
Parser PolarLandmarkPercept
Parser PolarLinePercept
Parser PolarPlayerPercept
Parser HearPercept
Parser GroundTruth
CognitionConfigLoader FieldDimensions
RobotModelProvider RobotDescription
RobotModelProvider FKModel
TorsoAngleEstimator TorsoAngles
TorsoAngleEstimator UprightVec
GroundContactDetector GroundContactState
TorsoPoseProvider TorsoPose
FallDetector FallState
AccEvaluator Odometry
PolarBallPerceptConverter BallPercept
AugmentedSelfLocator RobotPose
BallLocator LocalBallPos
BeliefCombinator BallPos
)";
}

std::string playingModules() {
  return std::string(perceptionModules()) + R"(BeforeKickOff BeforeKickOffOutput
Kicks SkillKickParameters
Striker2 StrikerOutput
BehaviorCombinator SkillRequest
BehaviorCombinator BeamRequest
SkillMoveToPos SkillMoveToPosOutput
FootSelector ActiveFoot
SkillGetBall SkillGetBallOutput
SkillKick SkillKickOutput
SkillDribble SkillDribbleOutput
SkillCombinator MotionRequest
MotionSelector MotionSelection
WalkingEngine WalkingEngineOutput
StandMotion StandOutput
SpecialActions SpecialActionsOutput
KickMotion KickMotionOutput
SimpleHeadMotion HeadMotionRequest
MotionCombinator JointRequest
JointPDControl JointRequestWithSpeeds
)";
}

}  // namespace test
}  // namespace plumbline
