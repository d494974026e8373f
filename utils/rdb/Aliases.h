#pragma once
#include <string>
#include <utility>
#include <vector>

namespace plumbline::rdb {

/// Short forms for typed commands: lines `A|B` of a file. An A at the beginning of a word becomes B.
class Aliases {
public:
  Aliases() = default;
  /// Throws std::runtime_error "file:line: ..." for a line of another form.
  static Aliases read(const std::string& path);
  void add(const std::string& from, const std::string& to) { aliases_.emplace_back(from, to); }
  std::string expand(const std::string& line) const;

private:
  std::vector<std::pair<std::string, std::string>> aliases_;
};

}  // namespace plumbline::rdb
