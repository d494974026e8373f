#pragma once
#include <cstdint>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace plumbline::record {

class Statement;

/// An SQLite file. Every failure is std::runtime_error "PATH: what SQLite says".
class Database {
public:
  enum class Mode { create, read };
  /// create: the file must not exist. read: first repairs what a killed writer left unfinished.
  Database(const std::string& path, Mode mode);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql);
  std::int64_t lastId() const;
  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& what) const;

private:
  friend class Statement;
  [[noreturn]] void failNow() const;

  std::string path_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement; values are bound in the order of its question marks; the caller keeps them valid
/// until the next step.
class Statement {
public:
  Statement(Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  template <typename... T>
  Statement& with(const T&... values) {
    reset();
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }
  /// True if there is a row.
  bool step();
  /// Runs a statement that returns no rows.
  void run() {
    while (step()) {
    }
  }
  std::int64_t integer(int column) const;
  /// Valid until the next step.
  std::string_view text(int column) const;
  std::string_view blob(int column) const;

private:
  void reset();
  void bind(int index, std::int64_t value);
  void bind(int index, std::string_view text);
  struct Bytes {
    std::string_view data;
  };

public:
  static Bytes bytes(std::string_view data) { return {data}; }

private:
  void bind(int index, Bytes blob);

  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace plumbline::record
