#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "RealRuns.h"

namespace plumbline::bench {

/// What a split came to, kept in a folder so that a run that was stopped goes on and a split can be run
/// alone. The file is <folder>/<robot>.<split>.<method>.json with "page" (Markdown), "figures", "closed",
/// "mean", "claimed" (null: blocks claim nothing of this kind) and "date".
class KeptSplit {
public:
  KeptSplit(const std::string& folder, const std::string& robot, const std::string& split, Method method);

  bool done() const;
  /// Errors: none of it there, or not readable (std::runtime_error with the file's name).
  nlohmann::json read() const;
  void write(const RealSplit& split, const RealResult& result) const;

private:
  std::string id_;  ///< <robot>.<split>.<method>
  Method method_;
  std::string file_;
};

}  // namespace plumbline::bench
