#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "math/Angle.h"
#include "simspark/ServerMessage.h"
#include "simspark/ServerMessageParser.h"

namespace plumbline::simspark {

/// Where the parser's actions put what they read; converts SimSpark's axes, degrees and signs into the
/// project's. A node is filled field by field and taken over when it closes, so that fields may come in any
/// order.
class ServerMessageBuilder {
public:
  explicit ServerMessageBuilder(ServerMessage& message) : message(message) {}

  /// The word as a number; anything else is remembered as the message's error, at the word.
  double number(std::string_view word);
  int integer(std::string_view word);
  void fail(const char* what);
  bool failed() const { return error.has_value(); }

  void gyro(double x, double y, double z) {
    message.gyro = axes(fromDegrees(x), fromDegrees(y), fromDegrees(z));
  }
  void acc(double x, double y, double z) { message.acc = axes(x, y, z); }
  void name(std::string_view word) { nodeName_ = word; }
  void angle(double degrees) { nodeAngle_ = degrees; }
  void closeHingeJoint();
  void point(double x, double y, double z) { reading_.point = axes(x, y, z); }
  void force(double x, double y, double z) { reading_.force = axes(x, y, z); }
  void closeForce();
  /// (hear team time self|direction text); older servers name no team.
  void hear(std::string_view team, std::string_view time, std::string_view direction, std::string_view text);

  void openSee() { message.see.emplace(); }
  /// One with a "nan" is left out, and with it the line or object it belongs to: the league's server clips
  /// lines to what is seen and now and then divides by zero there.
  void polar(std::string_view distance, std::string_view azimuth, std::string_view elevation);
  void closeObject(std::string_view objectName);
  void openPlayer() { message.see->players.emplace_back(); }
  SeenPlayer& player() { return message.see->players.back(); }
  void closePart(std::string_view part);
  void closeLine();

  void openGroundTruth();
  GroundTruth& truth() { return *message.groundTruth; }
  void openTruePlayer() { truth().players.emplace_back(); }
  GroundTruthPlayer& truePlayer() { return truth().players.back(); }
  void up(double x, double y, double z) { upAxis_ = Vec3(x, y, z); }
  void forward(double x, double y, double z) { forwardAxis_ = Vec3(x, y, z); }
  void closeGroundTruth();

  ServerMessage& message;
  const char* text = nullptr;  ///< the scanner's copy of the message; words point into it
  std::size_t position = 0;    ///< byte behind the last word read
  std::size_t wordStart = 0;   ///< its first byte
  std::optional<ParseError> error;

private:
  void fail(std::string_view word, const char* what);
  static Vec3 axes(double x, double y, double z) { return Vec3(y, -x, z); }

  std::string_view nodeName_;
  double nodeAngle_ = 0;
  ForceReading reading_;
  std::array<Polar, 2> polars_;
  int numPolars_ = 0;
  Vec3 upAxis_ = Vec3::UnitZ(), forwardAxis_ = Vec3::UnitX();
};

}  // namespace plumbline::simspark
