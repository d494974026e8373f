#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"

namespace plumbline {

struct HeardText : public Streamable {
  std::string team;
  double time = 0;  ///< game clock [s]
  bool self = false;
  double direction = 0;  ///< [rad, left positive]
  std::string text;
  void stream(InStream* in, OutStream* out) override {
    STREAM(team);
    STREAM(time);
    STREAM(self);
    STREAM(direction);
    STREAM(text);
  }
};

REPRESENTATION(HearPercept)
class HearPercept : public HearPerceptBase {
public:
  std::vector<HeardText> messages;
  void stream(InStream* in, OutStream* out) override { STREAM(messages); }
};

}  // namespace plumbline
