#pragma once
#include <string>
#include <vector>

#include "gap/settings/SettingsDiagnosis.h"

namespace plumbline::gap {

/// The first seconds of six recordings of the league's server.
inline std::vector<simspark::LeagueTrace> leagueTraces() {
  std::vector<simspark::LeagueTrace> traces;
  for (const char* name :
       {"crouch_t0", "crouch_t1", "ut_turn_t1", "ut_turn_t2", "ut_walk_t0", "ut_walk_t3"}) {
    traces.push_back(simspark::readLeagueTrace(std::string("tests/data/traces/") + name + ".csv.gz"));
    traces.back().rows.resize(180);
  }
  return traces;
}

/// Diagnoses them with windows of 5 rows, one in 16.
inline SettingsDiagnosis diagnosisOfTraces(const SimulatorSetup& nominal) {
  const TraceEvidence evidence(leagueTraces(), 5, 16);
  SettingsOptions options;
  options.jobs = 2;
  return diagnoseSettings(evidence, nominal, options);
}

}  // namespace plumbline::gap
