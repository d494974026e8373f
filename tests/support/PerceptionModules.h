#pragma once
#include <string>

namespace plumbline::test {

/// What the module TestServer hands to the parser next; give it to the controller's objects.
struct MessageSource {
  std::string text;
};

/// A modules.cfg of all that perceives, with TestServer in the connection's place and the ground truth.
const char* perceptionModules();

/// The same and one robot's play and motions behind it, down to the speeds of the joints.
std::string playingModules();

}  // namespace plumbline::test
