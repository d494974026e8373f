#include "simspark/ServerMessageWriter.h"

#include <cmath>

#include "math/Angle.h"
#include "simspark/JointNames.h"
#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

namespace {

class Writer {
public:
  Writer(std::string& out_, const ServerMessage& message_, int decimals_)
      : out(out_), message(message_), groundTruthDecimals(decimals_) {}

  void write() {
    out += "(time (now ";
    appendFixed(out, message.time);
    out += "))";
    gameState();
    for (const HeardMessage& heard : message.heard) hear(heard);
    out += "(GYR (n torso) (rt";
    vector(message.gyro * toDegrees(1));
    out += "))(ACC (n torso) (a";
    vector(message.acc);
    out += "))";
    if (message.groundTruth) groundTruth(*message.groundTruth);
    joints(headYaw, headPitch);
    if (message.see) see(*message.see);
    joints(rShoulderPitch, rElbowRoll);
    joints(lShoulderPitch, lElbowRoll);
    leg(rHipYawPitch, "rf", message.rightFoot, "rf1", message.rightToe);
    leg(lHipYawPitch, "lf", message.leftFoot, "lf1", message.leftToe);
  }

private:
  void number(double value) {
    out += ' ';
    appendFixed(out, value);
  }

  /// A vector of the project's axes in SimSpark's: x right, y forward, z up.
  void vector(const Vec3& v) {
    number(-v.y());
    number(v.x());
    number(v.z());
  }

  void gameState() {
    const GameState& state = message.gameState;
    out += "(GS ";
    if (state.unum) {
      out += "(unum ";
      appendInteger(out, *state.unum);
      out += ") ";
    }
    if (state.side) out += "(team " + *state.side + ") ";
    out += "(sl ";
    appendInteger(out, state.scoreLeft);
    out += ") (sr ";
    appendInteger(out, state.scoreRight);
    out += ") (t ";
    appendFixed(out, state.time);
    out += ") (pm ";
    out += state.playMode;
    out += "))";
  }

  void hear(const HeardMessage& heard) {
    out += "(hear ";
    if (!heard.team.empty()) out += heard.team + ' ';
    appendFixed(out, heard.time);
    if (heard.self)
      out += " self";
    else
      number(toDegrees(heard.direction));
    out += ' ';
    out += heard.text;
    out += ')';
  }

  void joints(int first, int last) {
    for (int i = first; i <= last; ++i) {
      const auto& angle = message.angle[static_cast<std::size_t>(i)];
      if (!angle) continue;
      const JointName& name = simsparkName(static_cast<JointId>(i));
      out += "(HJ (n ";
      out += name.perceptor;
      out += ") (ax";
      number(name.sign * toDegrees(*angle));
      out += "))";
    }
  }

  void force(const char* name, const std::optional<ForceReading>& reading) {
    if (!reading) return;
    out += "(FRP (n ";
    out += name;
    out += ") (c";
    vector(reading->point);
    out += ") (f";
    vector(reading->force);
    out += "))";
  }

  /// The force of a foot stands before the joint that moves it, that of a toe likewise.
  void leg(int first, const char* foot, const std::optional<ForceReading>& footForce, const char* toe,
           const std::optional<ForceReading>& toeForce) {
    joints(first, first + 4);
    force(foot, footForce);
    joints(first + 5, first + 5);
    force(toe, toeForce);
    joints(first + 6, first + 6);
  }

  void polar(const Polar& p) {
    out += "(pol";
    number(p.distance);
    number(toDegrees(p.azimuth));
    number(toDegrees(p.elevation));
    out += ')';
  }

  void see(const See& seen) {
    out += "(See";
    for (const SeenObject& object : seen.objects) {
      out += " (";
      out += object.name;
      out += ' ';
      polar(object.position);
      out += ')';
    }
    for (const SeenPlayer& player : seen.players) {
      out += " (P (team ";
      out += player.team;
      out += ") (id ";
      appendInteger(out, player.unum);
      out += ')';
      for (const SeenBodyPart& part : player.parts) {
        out += " (";
        out += part.name;
        out += ' ';
        polar(part.position);
        out += ')';
      }
      out += ')';
    }
    for (const SeenLine& line : seen.lines) {
      out += " (L ";
      polar(line.a);
      out += ' ';
      polar(line.b);
      out += ')';
    }
    out += ')';
  }

  void truthNumber(double value) {
    out += ' ';
    appendFixed(out, value, groundTruthDecimals);
  }

  void truthVector(const Vec3& v) {
    for (int i = 0; i < 3; ++i) truthNumber(v[i]);
  }

  void groundTruth(const GroundTruth& truth) {
    const Vec3 position = truth.T_world_torso.translation();
    const Vec3 forward = truth.T_world_torso.linear().col(0);
    out += "(GT (mypos (pose";
    truthNumber(position.x());
    truthNumber(position.y());
    truthNumber(std::atan2(forward.y(), forward.x()));
    out += ") (up";
    truthVector(truth.T_world_torso.linear().col(2));
    out += ") (z";
    truthNumber(position.z());
    out += ") (forward";
    truthVector(forward);
    out += ")) (B (";
    appendFixed(out, truth.ball.x(), groundTruthDecimals);
    truthNumber(truth.ball.y());
    truthNumber(truth.ball.z());
    out += "))";
    for (const GroundTruthPlayer& player : truth.players) {
      out += " (P (team ";
      out += player.team;
      out += ") (id ";
      appendInteger(out, player.unum);
      out += ") (pose";
      truthNumber(player.x);
      truthNumber(player.y);
      truthNumber(player.heading);
      out += "))";
    }
    out += ')';
  }

  std::string& out;
  const ServerMessage& message;
  int groundTruthDecimals;
};

}  // namespace

void appendServerMessage(std::string& out, const ServerMessage& message, int groundTruthDecimals) {
  Writer(out, message, groundTruthDecimals).write();
}

}  // namespace plumbline::simspark
