#include "training/WalkCheckpoint.h"

#include <bit>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/ReadFile.h"
#include "framework/SteadyClock.h"
#include "framework/WriteFile.h"

namespace plumbline::training {
namespace {

using nlohmann::json;

constexpr std::uintmax_t maxFileSize = 64 << 20;

std::string hexOf(std::uint64_t bits) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
  return text;
}

double numberOfHex(const std::string& text) {
  std::uint64_t bits = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, bits, 16);
  if (error != std::errc() || stop != end || text.size() != 16)
    throw std::invalid_argument("no number: " + text);
  return std::bit_cast<double>(bits);
}

std::string hexOf(const std::string& bytes) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    text += digits[static_cast<unsigned char>(c) >> 4];
    text += digits[static_cast<unsigned char>(c) & 15];
  }
  return text;
}

std::string bytesOf(const std::string& text) {
  std::string bytes;
  if (text.size() % 2 != 0) throw std::invalid_argument("half a byte");
  for (std::size_t i = 0; i < text.size(); i += 2) {
    unsigned byte = 0;
    const auto [stop, error] = std::from_chars(text.data() + i, text.data() + i + 2, byte, 16);
    if (error != std::errc() || stop != text.data() + i + 2) throw std::invalid_argument("no byte");
    bytes += static_cast<char>(byte);
  }
  return bytes;
}

}  // namespace

std::string exactText(const walking::WalkGaits& gaits) {
  std::string text;
  const auto add = [&](const walking::WalkParameters& p) {
    for (const walking::WalkParameter& one : walking::walkParameters())
      text += hexOf(std::bit_cast<std::uint64_t>(one.of(p))) + " ";
    text += "\n";
  };
  add(gaits.base);
  for (const walking::WalkParameters& corner : gaits.corner) add(corner);
  add(gaits.recovery);
  return text;
}

walking::WalkGaits walkOfExactText(const std::string& text) {
  std::istringstream in(text);
  // Without memory it throws, and does not take that for the end of the text.
  in.exceptions(std::ios::badbit);
  std::string word;
  const auto read = [&](walking::WalkParameters& p) {
    for (const walking::WalkParameter& one : walking::walkParameters()) {
      if (!(in >> word)) throw std::invalid_argument("the walk is cut short");
      one.of(p) = numberOfHex(word);
    }
  };
  walking::WalkGaits gaits;
  read(gaits.base);
  for (walking::WalkParameters& corner : gaits.corner) read(corner);
  read(gaits.recovery);
  if (in >> word) throw std::invalid_argument("the walk goes on");
  return gaits;
}

WalkCheckpoint::WalkCheckpoint(std::string file, std::string mark)
    : file_(std::move(file)), mark_(std::move(mark)) {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return;
  read();
  resumed_ = true;
}

void WalkCheckpoint::read() {
  const auto fail = [&](const std::string& what) {
    throw ConfigurationError(file_ + " " + what + "; remove it to begin anew");
  };
  std::error_code error;
  if (std::filesystem::file_size(file_, error) > maxFileSize || error) fail("is not the state of a search");
  std::string text;
  try {
    text = readFile(file_, maxFileSize);
  } catch (const FileProblem& problem) {
    throw ConfigurationError(file_ + ": " + problem.what());
  }
  // Flat: what is nested deeper was not written here.
  const auto flat = [&](int depth, json::parse_event_t, json&) {
    if (depth > 3) fail("is damaged");
    return true;
  };
  try {
    const json state = json::parse(text, flat);
    if (state.at("mark").get<std::string>() != mark_)
      fail("is of a search with other options, another walk to begin with or another program");
    for (const json& walk : state.at("done")) done_.push_back(walkOfExactText(walk.get<std::string>()));
    search_ = bytesOf(state.at("search").get<std::string>());
  } catch (const json::exception&) {
    fail("is damaged");
  } catch (const std::invalid_argument&) {
    fail("is damaged");
  }
}

void WalkCheckpoint::write() {
  json state;
  state["mark"] = mark_;
  state["done"] = json::array();
  for (const walking::WalkGaits& walk : done_) state["done"].push_back(exactText(walk));
  state["search"] = hexOf(search_);
  writeFile(file_, state.dump(1) + "\n");
  written_ = steadySeconds();
}

walking::WalkGaits WalkCheckpoint::stage(const std::function<walking::WalkGaits()>& work) {
  if (next_ < done_.size()) return done_[next_++];
  walking::WalkGaits gaits = work();
  done_.push_back(gaits);
  ++next_;
  search_.clear();
  write();
  return gaits;
}

void WalkCheckpoint::storeSearch(const std::string& state) {
  search_ = state;
  // The clock only decides how often the file is written.
  if (steadySeconds() - written_ >= 1) write();
}

void WalkCheckpoint::forget() { std::remove(file_.c_str()); }

}  // namespace plumbline::training
