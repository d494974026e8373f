#pragma once
#include <gtest/gtest.h>

#include <string>

#include "situation/SituationFile.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::test {

/// Most lines of a situation's file that there are.
const std::string strikersFile =
    "about: \"Nobody is near.\"\n"
    "decides: striker\n"
    "robot: [-0.5, 0.0, 0.1]\n"
    "ball: [0.0, 0.25]\n"
    "mates: [[-4, 3, 7], [-5, -3]]\n"
    "velocities: [[0.5, 0]]\n"
    "going: [[-2, 4, 1.5]]\n"
    "opponents: [[9, 1]]\n"
    "kicks: [{reach: 3.4, spread: 0.5, scatter: 90, rise: 0.2}]\n"
    "expected: {action: kick, direction: [-0.7, 0.7], reach: [2, 4]}\n";

/// Reads situations from texts.
struct SituationReading : testing::Test {
  Situation read(const std::string& text) const {
    scratch.write("one.yaml", text);
    return readSituation(scratch / "one.yaml");
  }
  /// What is said of a file, without its folder.
  std::string errorOf(const std::string& text) const {
    const std::string what = thrownBy([&] { read(text); });
    const std::string folder = scratch.path() + "/";
    return what.rfind(folder, 0) == 0 ? what.substr(folder.size()) : what;
  }
  /// What is said of the striker's file with a part of it replaced.
  std::string errorWith(const std::string& part, const std::string& by) const {
    std::string text = strikersFile;
    return errorOf(text.replace(text.find(part), part.size(), by));
  }
  ScratchFolder scratch;
};

}  // namespace plumbline::test
