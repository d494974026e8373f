#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Pose2.h"
#include "math/Types.h"

namespace plumbline {

/// An opponent as a mate tells of it.
struct SaidOpponent : public Streamable {
  int number = 0;                ///< 1 to 11
  Vec2 position = Vec2::Zero();  ///< team's frame [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(number);
    STREAM(position);
  }
};

/// What one player tells the others at a time; in the team's frame [m, m/s, rad].
struct TeamBelief : public Streamable {
  static constexpr std::size_t maxOpponents = 2;

  int number = 0;  ///< of the speaker, 1 to 11
  Pose2 pose;
  bool localised = false;
  bool fallen = false;
  int role = 0;           ///< see PlayerRole
  double timeToBall = 0;  ///< see PlayerRole [s]
  bool ballKnown = false;
  double ballAge = 0;  ///< since the speaker saw it [s]
  Vec2 ball = Vec2::Zero();
  Vec2 ballVelocity = Vec2::Zero();
  std::vector<SaidOpponent> opponents;  ///< at most maxOpponents; seen just before
  void stream(InStream* in, OutStream* out) override {
    STREAM(number);
    STREAM("position", pose.position);
    STREAM("heading", pose.heading);
    STREAM(localised);
    STREAM(fallen);
    STREAM(role);
    STREAM(timeToBall);
    STREAM(ballKnown);
    STREAM(ballAge);
    STREAM(ball);
    STREAM(ballVelocity);
    STREAM(opponents);
  }
};

/// What this player would say now; BeliefShare fills it.
REPRESENTATION(TeamComDataOut)
class TeamComDataOut : public TeamComDataOutBase {
public:
  TeamBelief belief;
  void stream(InStream* in, OutStream* out) override { STREAM(belief); }
};

/// What was heard of mates in this cycle.
REPRESENTATION(TeamComDataIn)
class TeamComDataIn : public TeamComDataInBase {
public:
  std::vector<TeamBelief> beliefs;
  unsigned heard = 0;    ///< texts of the own team so far
  unsigned refused = 0;  ///< of these, not believed
  void stream(InStream* in, OutStream* out) override {
    STREAM(beliefs);
    STREAM(heard);
    STREAM(refused);
  }
};

/// The text to be said in this cycle; empty: nothing.
REPRESENTATION(SayMessage)
class SayMessage : public SayMessageBase {
public:
  std::string text;
  TeamBelief said;   ///< what the last text was about, as mates understand it
  double time = -1;  ///< FrameInfo time of the last text [s]
  void stream(InStream* in, OutStream* out) override {
    STREAM(text);
    STREAM(said);
    STREAM(time);
  }
};

}  // namespace plumbline
