#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "framework/Config.h"
#include "math/Types.h"
#include "representations/infrastructure/TeamPlayModeNames.h"

namespace plumbline {

/// A place in a set piece, relative to the ball's place. Files give it for a ball on the left or in the
/// middle; for a ball on the right it is mirrored. Team's frame [m].
struct SetPiecePlace {
  enum class Frame {
    field,    ///< x, y on the field
    ball,     ///< from the ball: ahead (to the opponents' goal line), inwards (to the other side line)
    ownGoal,  ///< from the ball: goalwards (on the line to the own goal), aside (to the left of that line)
  };
  Frame frame = Frame::field;
  double first = 0, second = 0;

  /// onRight: the piece is played on the right side, see SetPieceSide.
  Vec2 at(const Vec2& ball, double halfLength, bool onRight) const;
};

/// What a team does in some play modes: one file of config/set_pieces/, which a coach edits.
struct SetPiece {
  std::string name;  ///< of the file
  std::vector<TeamPlayMode> modes;
  std::vector<SetPiecePlace> kick;     ///< where the striker may kick the ball; empty: as in play
  std::optional<SetPiecePlace> stand;  ///< where the striker waits at the opponents' restart
  std::vector<SetPiecePlace> places;   ///< of the first supporters, instead of those of the formation
  double lasts = 0;                    ///< places hold for so long after the mode has ended [s]
};

/// On which side a set piece is played: the ball's when it begins. A ball near the middle counts as one on
/// the left. The side changes only with a ball clearly on the other one: else noise would swap it in each
/// cycle.
class SetPieceSide {
public:
  static constexpr double middle = 0.5;  ///< [m]

  /// In each cycle. piece: the one that is played. ball [m, team's frame].
  void update(const SetPiece* piece, const Vec2& ball);
  bool onRight() const { return onRight_; }

private:
  const SetPiece* piece_ = nullptr;
  bool onRight_ = false;
};

/// All files of config/set_pieces/. Throws ConfigurationError with file, line and key; a mode belongs to one
/// file at most.
class SetPieces {
public:
  SetPieces() = default;
  explicit SetPieces(const Config& config);

  /// Null: there is none for this mode.
  const SetPiece* of(TeamPlayMode mode) const;
  const std::vector<SetPiece>& all() const { return pieces_; }

private:
  std::vector<SetPiece> pieces_;
  std::array<std::optional<std::size_t>, teamPlayModeNames.size()> ofMode_{};  ///< index of its piece
};

/// One file's content. Throws ConfigurationError.
SetPiece readSetPiece(const std::string& name, const ConfigSection& file);

}  // namespace plumbline
