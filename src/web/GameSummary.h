#pragma once
#include <string>

namespace plumbline::web {

/// A recorded game as JSON for the page of its summary: sizes of the field, teams, and changes of score and
/// play mode {"t":,"game":,"half":,"mode":,"left":,"right":}. Positions are given ten times a second of the
/// game, in centimetres: "times" [s of the recording], "clock" [s of the game], "ball" [x, y, z, ...] and
/// "robots" [{"side":,"unum":,"track":[x, y, up, ...]}]. up is 1 if the torso is upright; null while a robot
/// is absent. Throws std::runtime_error, one line, for another file.
std::string gameTracks(const std::string& recording);

/// The page of a recorded game, complete in itself: `replay` is where bin/webmonitor --replay shows it;
/// `decisions` is what gameDecisions returns (DecisionFiles.h), or "null".
std::string summaryPage(const std::string& builtPage, const std::string& tracks, const std::string& replay,
                        const std::string& decisions = "null");

/// The page to be filled, beside the running program; throws std::runtime_error, one line, if it is not
/// built.
std::string builtSummaryPage();

}  // namespace plumbline::web
