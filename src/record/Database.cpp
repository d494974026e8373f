#include "record/Database.h"

#include <sqlite3.h>

#include <filesystem>
#include <stdexcept>

namespace plumbline::record {

namespace {
constexpr int patience = 5000;  ///< with another program that writes the file [ms]
}

Database::Database(const std::string& path, Mode mode) : path_(path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const bool there = fs::exists(path, error);
  if (mode == Mode::create && there) fail("exists already");
  if (mode == Mode::read && !fs::is_regular_file(path, error)) fail("is no file");
  const int flags = mode == Mode::create ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READWRITE;
  int status = sqlite3_open_v2(path.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  if (status == SQLITE_OK && mode == Mode::read && sqlite3_db_readonly(handle_, "main") == 1) {
    // In a folder that may not be written to, unfinished data stay unread.
    sqlite3_close(handle_);
    handle_ = nullptr;
    const std::string uri = "file:" + path + "?immutable=1";
    const bool plain = path.find_first_of("?#%") == std::string::npos;
    status =
        sqlite3_open_v2(plain ? uri.c_str() : path.c_str(), &handle_,
                        SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX | (plain ? SQLITE_OPEN_URI : 0), nullptr);
  }
  if (status != SQLITE_OK) {
    const std::string what = handle_ ? sqlite3_errmsg(handle_) : "no memory";
    sqlite3_close(handle_);
    fail(what);
  }
  sqlite3_busy_timeout(handle_, patience);
}

Database::~Database() { sqlite3_close(handle_); }

void Database::fail(const std::string& what) const { throw std::runtime_error(path_ + ": " + what); }
void Database::failNow() const { fail(sqlite3_errmsg(handle_)); }

void Database::run(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) failNow();
}

std::int64_t Database::lastId() const { return sqlite3_last_insert_rowid(handle_); }

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle_, sql.c_str(), -1, &handle_, nullptr) != SQLITE_OK)
    database.failNow();
}

Statement::~Statement() { sqlite3_finalize(handle_); }

void Statement::reset() { sqlite3_reset(handle_); }

void Statement::bind(int index, std::int64_t value) {
  if (sqlite3_bind_int64(handle_, index, value) != SQLITE_OK) database_.failNow();
}

void Statement::bind(int index, std::string_view text) {
  if (sqlite3_bind_text64(handle_, index, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8) != SQLITE_OK)
    database_.failNow();
}

void Statement::bind(int index, Bytes blob) {
  if (sqlite3_bind_blob64(handle_, index, blob.data.data(), blob.data.size(), SQLITE_STATIC) != SQLITE_OK)
    database_.failNow();
}

bool Statement::step() {
  const int status = sqlite3_step(handle_);
  if (status == SQLITE_ROW) return true;
  if (status != SQLITE_DONE) {
    const std::string what = sqlite3_errmsg(sqlite3_db_handle(handle_));
    sqlite3_reset(handle_);
    database_.fail(what);
  }
  sqlite3_reset(handle_);
  return false;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

std::string_view Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return {data ? data : "", data ? static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)) : 0};
}

std::string_view Statement::blob(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return {data ? data : "", data ? static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)) : 0};
}

}  // namespace plumbline::record
