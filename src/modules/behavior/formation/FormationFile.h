#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "framework/Streamable.h"

namespace plumbline {

/// A place of the formation's file, as it streams: a row for each ballY, a column for each ballX [m].
struct FormationDraftPlace {
  std::string name;
  std::vector<std::vector<double>> x, y;
  void stream(InStream* in, OutStream* out) {
    STREAM(name);
    STREAM(x);
    STREAM(y);
  }
};

/// The formation's file in the debug interface.
struct FormationDraft {
  std::string file;      ///< path
  std::string revision;  ///< of the text that it was read from
  std::string comment;   ///< why it cannot be edited; empty: it can
  std::vector<double> ballX, ballY;
  std::vector<FormationDraftPlace> places;
  void stream(InStream* in, OutStream* out) {
    STREAM(file);
    STREAM(revision);
    STREAM(comment);
    STREAM(ballX);
    STREAM(ballY);
    STREAM(places);
  }
};

/// config/formation.yaml, read and written by an editor that moves places. What is written is the text with
/// other numbers: comments, order and the numbers that stay are as they were.
class FormationFile {
public:
  explicit FormationFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// As it is on the disk now; one that cannot be edited says why in `comment`.
  FormationDraft read() const;
  /// Writes it beside its place, syncs and renames. False: there was nothing to change. Throws
  /// std::runtime_error for a draft with other places or balls than the file, with numbers that no table may
  /// have, and where the file is no longer of the draft's revision or cannot be written.
  bool write(const FormationDraft& draft) const;

private:
  std::filesystem::path file_;
};

}  // namespace plumbline
