#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// A point in the head's frame: distance [m], azimuth [rad, left positive], elevation [rad, up positive].
struct PolarPoint : public Streamable {
  double distance = 0, azimuth = 0, elevation = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(distance);
    STREAM(azimuth);
    STREAM(elevation);
  }
};

struct PolarLandmark : public Streamable {
  std::string name;  ///< F1L F2L F1R F2R G1L G2L G1R G2R, as on the server's field
  PolarPoint position;
  void stream(InStream* in, OutStream* out) override {
    STREAM(name);
    STREAM(position);
  }
};

struct PolarLine : public Streamable {
  PolarPoint a, b;
  void stream(InStream* in, OutStream* out) override {
    STREAM(a);
    STREAM(b);
  }
};

struct PolarBodyPart : public Streamable {
  std::string name;  ///< head, rlowerarm, llowerarm, rfoot, lfoot
  PolarPoint position;
  void stream(InStream* in, OutStream* out) override {
    STREAM(name);
    STREAM(position);
  }
};

struct PolarPlayer : public Streamable {
  std::string team;
  int number = 0;
  std::vector<PolarBodyPart> parts;
  void stream(InStream* in, OutStream* out) override {
    STREAM(team);
    STREAM(number);
    STREAM(parts);
  }
};

/// Whether there was an image in this cycle; without one the polar percepts are empty.
REPRESENTATION(VisionInfo)
class VisionInfo : public VisionInfoBase {
public:
  bool newImage = false;
  void stream(InStream* in, OutStream* out) override { STREAM(newImage); }
};

REPRESENTATION(PolarBallPercept)
class PolarBallPercept : public PolarBallPerceptBase {
public:
  bool seen = false;
  PolarPoint position;
  void stream(InStream* in, OutStream* out) override {
    STREAM(seen);
    STREAM(position);
  }
};

/// Flags and goal posts in view.
REPRESENTATION(PolarLandmarkPercept)
class PolarLandmarkPercept : public PolarLandmarkPerceptBase {
public:
  std::vector<PolarLandmark> landmarks;
  void stream(InStream* in, OutStream* out) override { STREAM(landmarks); }
};

/// Field lines in view, clipped to the image.
REPRESENTATION(PolarLinePercept)
class PolarLinePercept : public PolarLinePerceptBase {
public:
  std::vector<PolarLine> lines;
  void stream(InStream* in, OutStream* out) override { STREAM(lines); }
};

/// Body parts of players in view, the own arms among them.
REPRESENTATION(PolarPlayerPercept)
class PolarPlayerPercept : public PolarPlayerPerceptBase {
public:
  std::vector<PolarPlayer> players;
  void stream(InStream* in, OutStream* out) override { STREAM(players); }
};

}  // namespace plumbline
