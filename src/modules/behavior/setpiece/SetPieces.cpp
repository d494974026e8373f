#include "modules/behavior/setpiece/SetPieces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "framework/NearestName.h"

namespace plumbline {
namespace {

constexpr double farthest = 100;      ///< [m]
constexpr double longest = 30;        ///< [s]
constexpr std::size_t maxPlaces = 9;  ///< with goalie and striker eleven

/// The modes in which somebody brings the ball into play.
constexpr TeamPlayMode restarts[] = {
    TeamPlayMode::kickOffOwn,       TeamPlayMode::kickOffOpponent,   TeamPlayMode::kickInOwn,
    TeamPlayMode::kickInOpponent,   TeamPlayMode::cornerOwn,         TeamPlayMode::cornerOpponent,
    TeamPlayMode::goalKickOwn,      TeamPlayMode::goalKickOpponent,  TeamPlayMode::freeKickOwn,
    TeamPlayMode::freeKickOpponent, TeamPlayMode::directFreeKickOwn, TeamPlayMode::directFreeKickOpponent,
    TeamPlayMode::passOpponent};

TeamPlayMode modeOf(const std::string& word, const ConfigSection& file) {
  std::vector<std::string> words;
  for (const TeamPlayMode mode : restarts) {
    if (word == teamPlayModeName(mode)) return mode;
    words.emplace_back(teamPlayModeName(mode));
  }
  file.fail("modes", "has \"" + word.substr(0, 40) + "\", which is no play mode" + suggestion(word, words));
}

SetPiecePlace placeOf(const ConfigSection& section) {
  struct Form {
    SetPiecePlace::Frame frame;
    const char *first, *second;
  };
  using Frame = SetPiecePlace::Frame;
  for (const Form& form : {Form{Frame::ball, "ahead", "inwards"}, Form{Frame::ownGoal, "goalwards", "aside"}})
    if (section.has(form.first) || section.has(form.second))
      return {form.frame, section.get<double>(form.first, {-farthest, farthest}),
              section.get<double>(form.second, {-farthest, farthest})};
  return {Frame::field, section.get<double>("x", {-farthest, farthest}),
          section.get<double>("y", {-farthest, farthest})};
}

std::vector<SetPiecePlace> placesOf(const ConfigSection& file, const char* key, std::size_t most) {
  std::vector<SetPiecePlace> places;
  if (!file.has(key)) return places;
  for (const ConfigSection& section : file.list(key)) places.push_back(placeOf(section));
  if (places.size() > most)
    file.fail(key, "must be " + std::to_string(most) + " at most, not " + std::to_string(places.size()));
  return places;
}

}  // namespace

Vec2 SetPiecePlace::at(const Vec2& ball, double halfLength, bool onRight) const {
  const double side = onRight ? -1 : 1;
  const Vec2 onLeft(ball.x(), side * ball.y());
  Vec2 place(first, second);
  if (frame == Frame::ball) place = onLeft + Vec2(first, -second);
  if (frame == Frame::ownGoal) {
    const Vec2 way = Vec2(-halfLength, 0) - onLeft;
    const Vec2 to = way.norm() > 1e-3 ? Vec2(way.normalized()) : Vec2(-1, 0);
    place = onLeft + first * to + second * Vec2(-to.y(), to.x());
  }
  return {place.x(), side * place.y()};
}

void SetPieceSide::update(const SetPiece* piece, const Vec2& ball) {
  if (piece != piece_) onRight_ = false;
  piece_ = piece;
  if (std::abs(ball.y()) > middle) onRight_ = ball.y() < 0;
}

SetPiece readSetPiece(const std::string& name, const ConfigSection& file) {
  SetPiece piece;
  piece.name = name;
  for (const std::string& word : file.get<std::vector<std::string>>("modes"))
    piece.modes.push_back(modeOf(word, file));
  if (piece.modes.empty()) file.fail("modes", "must name a play mode");
  piece.kick = placesOf(file, "kick", maxPlaces);
  if (const auto stand = placesOf(file, "stand", 1); !stand.empty()) piece.stand = stand.front();
  if (!piece.kick.empty() && piece.stand)
    file.fail("stand", "and kick exclude each other: the striker kicks or waits");
  piece.places = placesOf(file, "places", maxPlaces);
  piece.lasts = file.find<double>("lasts", {0, longest}).value_or(0);
  return piece;
}

SetPieces::SetPieces(const Config& config) {
  std::set<std::string> names;  // in their order, whatever the folder's is
  for (const std::string& directory : config.directories()) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::path(directory) / "set_pieces";
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
      if (at->path().extension() == ".yaml") names.insert(at->path().stem().string());
  }
  for (const std::string& name : names) {
    const ConfigSection& file = config.file("set_pieces/" + name);
    SetPiece piece = readSetPiece(name, file);
    for (const TeamPlayMode mode : piece.modes)
      if (const SetPiece* other = of(mode))
        file.fail("modes", "has a mode that " + other->name + ".yaml has already");
    for (const TeamPlayMode mode : piece.modes) ofMode_[static_cast<std::size_t>(mode)] = pieces_.size();
    pieces_.push_back(std::move(piece));
  }
}

const SetPiece* SetPieces::of(TeamPlayMode mode) const {
  const std::optional<std::size_t> piece = ofMode_[static_cast<std::size_t>(mode)];
  return piece ? &pieces_[*piece] : nullptr;
}

}  // namespace plumbline
