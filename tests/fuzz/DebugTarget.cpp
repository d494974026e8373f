// Lines of who looks into a running agent, in the debug port's protocol.
#include "framework/AgentDebug.h"
#include "fuzz/Readers.h"
#include "inspect/Inspector.h"

namespace plumbline::fuzz {
namespace {

/// Lines of one client.
void debugLine(std::string_view bytes) {
  AgentDebug agent;
  inspect::Inspector inspector(agent);
  const int client = inspector.open([](std::string_view line, bool) {
    require(line.find('\n') == std::string_view::npos, "an answer of more than one line");
    return true;
  });
  int lines = 0;
  for (std::size_t begin = 0; begin < bytes.size() && lines < 200; ++lines) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    inspector.command(client, bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  inspector.poll();
  inspector.close(client);
}

std::vector<std::string> debugLineSeeds() {
  return {"#1 get module:Walk:x\n#2 watch representation:BallPos .x 0.1\nunwatch #2\n",
          "set parameter:Walk:speed 0.5\nset a {x: [1, 2], y: \"z\"}\nunset parameter:Walk:speed\n",
          "list\nlist module:\ncomplete rep\nformat json\ntiming\ngraph\nabout\nproviders\nhelp\n",
          "run block\nrun once block\nrun off block\n#tag set once a [1, 2]\n"};
}

const Registered debugLineTarget({"debugLine", debugLine, debugLineSeeds, 6000});

}  // namespace
}  // namespace plumbline::fuzz
