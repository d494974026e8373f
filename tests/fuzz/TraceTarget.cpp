// Recordings of the league's server.
#include <zlib.h>

#include <algorithm>

#include "fuzz/Readers.h"
#include "simspark/LeagueRecording.h"
#include "simspark/LeagueTrace.h"

namespace plumbline::fuzz {
namespace {

void leagueTrace(std::string_view bytes) {
  const std::string path = scratchFile("traces/walk_t0.csv", bytes);
  refusesInOneLine([&] {
    const simspark::LeagueTrace trace = simspark::readLeagueTrace(path);
    require(trace.rows.size() >= 3, "a trace without motion");
  });
  refusesInOneLine([&] { require(simspark::readLeagueRecording(path).size() == 1, "a robot from nowhere"); });
}

/// The first lines of a recording.
std::string beginning(const char* file) {
  const gzFile stream = gzopen(file, "rb");
  std::string text(20000, '\0');
  text.resize(
      static_cast<std::size_t>(std::max(0, gzread(stream, text.data(), static_cast<unsigned>(text.size())))));
  gzclose(stream);
  return text.substr(0, text.rfind('\n') + 1);
}

std::vector<std::string> leagueTraceSeeds() {
  return {beginning("tests/data/traces/crouch_t4.csv.gz"), beginning("tests/data/traces/crouch_t0.csv.gz"),
          "cycle,gyr.x\n0\n"};
}

const Registered leagueTraceTarget({"leagueTrace", leagueTrace, leagueTraceSeeds, 1200});

}  // namespace
}  // namespace plumbline::fuzz
