#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::fuzz {

/// A reader of what comes from outside, and inputs it knows. run() takes any bytes: it may refuse them, but
/// neither crash, nor hang, nor throw; a throw of Broken says that the reader contradicts itself.
struct Target {
  const char* name;
  void (*run)(std::string_view bytes);
  std::vector<std::string> (*seeds)();
  int rounds;  ///< mutations in the bounded run of the tests
};

const std::vector<Target>& targets();

struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};
inline void require(bool holds, const char* what) {
  if (!holds) throw Broken(what);
}

// The targets, by file.
void agentMessage(std::string_view bytes);
void trainerMessage(std::string_view bytes);
void serverMessage(std::string_view bytes);
void monitorScene(std::string_view bytes);  ///< messages in lines
void framing(std::string_view bytes);       ///< first byte: size of the pieces it comes in
void fieldMessage(std::string_view bytes);
void roboViz(std::string_view bytes);
void matchFile(std::string_view bytes);
void pageCommand(std::string_view bytes);
/// Lines "0 message" to "3 message" to four agents, "t message" to the trainer's port, "." a cycle.
void session(std::string_view bytes);
void robotFile(std::string_view bytes);
/// A URDF and its servo table, "\n---\n" between them.
void urdfFile(std::string_view bytes);
/// run.json and run.csv, "\n---\n" between them.
void gapRun(std::string_view bytes);

std::vector<std::string> agentSeeds();
std::vector<std::string> trainerSeeds();
std::vector<std::string> serverSeeds();
std::vector<std::string> sceneSeeds();
std::vector<std::string> frameSeeds();
std::vector<std::string> fieldSeeds();
std::vector<std::string> roboVizSeeds();
std::vector<std::string> matchSeeds();
std::vector<std::string> pageSeeds();
std::vector<std::string> sessionSeeds();
std::vector<std::string> robotSeeds();
std::vector<std::string> urdfSeeds();
std::vector<std::string> runSeeds();

}  // namespace plumbline::fuzz
