#pragma once
#include "framework/Representation.h"
#include "motion/Keyframes.h"

namespace plumbline {

/// What a person who edits motions wants to see; nothing in a game. Its stream tells only that there is
/// something: a log does not replay an editor.
REPRESENTATION(EditedMotion)
class EditedMotion : public EditedMotionBase {
public:
  static constexpr const char* name = "(draft)";  ///< asks for `motion` as the name of a file asks for it

  motion::KeyframeMotion motion;
  unsigned saved = 0;  ///< counts files that were written: who has read motions reads them again

  void stream(InStream* in, OutStream* out) override { STREAM(saved); }
};

}  // namespace plumbline
