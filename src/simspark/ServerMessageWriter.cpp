#include "simspark/ServerMessageWriter.h"

#include <cmath>

#include "math/Angle.h"
#include "simspark/JointNames.h"
#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

namespace {

class Writer {
public:
  Writer(std::string& out, const ServerMessage& message, int decimals)
      : out_(out), message_(message), groundTruthDecimals_(decimals) {}

  void write() {
    out_ += "(time (now ";
    appendFixed(out_, message_.time);
    out_ += "))";
    gameState();
    for (const HeardMessage& heard : message_.heard) hear(heard);
    out_ += "(GYR (n torso) (rt";
    vector(message_.gyro * toDegrees(1));
    out_ += "))(ACC (n torso) (a";
    vector(message_.acc);
    out_ += "))";
    if (message_.groundTruth) groundTruth(*message_.groundTruth);
    joints(headYaw, headPitch);
    if (message_.see) see(*message_.see);
    joints(rShoulderPitch, rElbowRoll);
    joints(lShoulderPitch, lElbowRoll);
    leg(rHipYawPitch, "rf", message_.rightFoot, "rf1", message_.rightToe);
    leg(lHipYawPitch, "lf", message_.leftFoot, "lf1", message_.leftToe);
  }

private:
  void number(double value) {
    out_ += ' ';
    appendFixed(out_, value);
  }

  /// A vector of the project's axes in SimSpark's: x right, y forward, z up.
  void vector(const Vec3& v) {
    number(-v.y());
    number(v.x());
    number(v.z());
  }

  void gameState() {
    const GameState& state = message_.gameState;
    out_ += "(GS ";
    if (state.unum) {
      out_ += "(unum ";
      appendInteger(out_, *state.unum);
      out_ += ") ";
    }
    if (state.side) out_ += "(team " + *state.side + ") ";
    out_ += "(sl ";
    appendInteger(out_, state.scoreLeft);
    out_ += ") (sr ";
    appendInteger(out_, state.scoreRight);
    out_ += ") (t ";
    appendFixed(out_, state.time);
    out_ += ") (pm ";
    out_ += state.playMode;
    out_ += "))";
  }

  void hear(const HeardMessage& heard) {
    out_ += "(hear ";
    if (!heard.team.empty()) out_ += heard.team + ' ';
    appendFixed(out_, heard.time);
    if (heard.self)
      out_ += " self";
    else
      number(toDegrees(heard.direction));
    out_ += ' ';
    out_ += heard.text;
    out_ += ')';
  }

  void joints(int first, int last) {
    for (int i = first; i <= last; ++i) {
      const auto& angle = message_.angle[static_cast<std::size_t>(i)];
      if (!angle) continue;
      const JointName& name = simsparkName(static_cast<JointId>(i));
      out_ += "(HJ (n ";
      out_ += name.perceptor;
      out_ += ") (ax";
      number(name.sign * toDegrees(*angle));
      out_ += "))";
    }
  }

  void force(const char* name, const std::optional<ForceReading>& reading) {
    if (!reading) return;
    out_ += "(FRP (n ";
    out_ += name;
    out_ += ") (c";
    vector(reading->point);
    out_ += ") (f";
    vector(reading->force);
    out_ += "))";
  }

  /// The force of a foot comes before the joint that moves it, that of a toe likewise.
  void leg(int first, const char* foot, const std::optional<ForceReading>& footForce, const char* toe,
           const std::optional<ForceReading>& toeForce) {
    joints(first, first + 4);
    force(foot, footForce);
    joints(first + 5, first + 5);
    force(toe, toeForce);
    joints(first + 6, first + 6);
  }

  void polar(const Polar& p) {
    out_ += "(pol";
    number(p.distance);
    number(toDegrees(p.azimuth));
    number(toDegrees(p.elevation));
    out_ += ')';
  }

  void see(const See& seen) {
    out_ += "(See";
    for (const SeenObject& object : seen.objects) {
      out_ += " (";
      out_ += object.name;
      out_ += ' ';
      polar(object.position);
      out_ += ')';
    }
    for (const SeenPlayer& player : seen.players) {
      out_ += " (P (team ";
      out_ += player.team;
      out_ += ") (id ";
      appendInteger(out_, player.unum);
      out_ += ')';
      for (const SeenBodyPart& part : player.parts) {
        out_ += " (";
        out_ += part.name;
        out_ += ' ';
        polar(part.position);
        out_ += ')';
      }
      out_ += ')';
    }
    for (const SeenLine& line : seen.lines) {
      out_ += " (L ";
      polar(line.a);
      out_ += ' ';
      polar(line.b);
      out_ += ')';
    }
    out_ += ')';
  }

  void truthNumber(double value) {
    out_ += ' ';
    appendFixed(out_, value, groundTruthDecimals_);
  }

  void truthVector(const Vec3& v) {
    for (int i = 0; i < 3; ++i) truthNumber(v[i]);
  }

  void groundTruth(const GroundTruth& truth) {
    const Vec3 position = truth.T_world_torso.translation();
    const Vec3 forward = truth.T_world_torso.linear().col(0);
    out_ += "(GT (mypos (pose";
    truthNumber(position.x());
    truthNumber(position.y());
    truthNumber(std::atan2(forward.y(), forward.x()));
    out_ += ") (up";
    truthVector(truth.T_world_torso.linear().col(2));
    out_ += ") (z";
    truthNumber(position.z());
    out_ += ") (forward";
    truthVector(forward);
    out_ += ")) (B (";
    appendFixed(out_, truth.ball.x(), groundTruthDecimals_);
    truthNumber(truth.ball.y());
    truthNumber(truth.ball.z());
    out_ += "))";
    for (const GroundTruthPlayer& player : truth.players) {
      out_ += " (P (team ";
      out_ += player.team;
      out_ += ") (id ";
      appendInteger(out_, player.unum);
      out_ += ") (pose";
      truthNumber(player.x);
      truthNumber(player.y);
      truthNumber(player.heading);
      out_ += "))";
    }
    out_ += ')';
  }

  std::string& out_;
  const ServerMessage& message_;
  int groundTruthDecimals_;
};

}  // namespace

void appendServerMessage(std::string& out, const ServerMessage& message, int groundTruthDecimals) {
  Writer(out, message, groundTruthDecimals).write();
}

}  // namespace plumbline::simspark
