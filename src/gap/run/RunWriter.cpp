#include <zlib.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "framework/PartialFolder.h"
#include "framework/WriteFile.h"
#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json servoJson(const ServoOverride& servo) {
  ordered_json json = ordered_json::object();
  const auto put = [](ordered_json& to, const char* key, const std::optional<double>& x) {
    if (x) to[key] = *x;
  };
  put(json, "kp", servo.kp);
  put(json, "kd", servo.kd);
  put(json, "armature", servo.armature);
  put(json, "max_torque", servo.maxTorque);
  put(json, "max_speed", servo.maxSpeed);
  ordered_json motor = ordered_json::object();
  put(motor, "kp_firmware", servo.kpFirmware);
  put(motor, "vin", servo.vin);
  if (!motor.empty()) json["dc_motor"] = motor;
  return json;
}

std::string metaText(const Run& run) {
  ordered_json json;
  json["robot"] = run.robot;
  json["base"] = run.freeBase ? "free" : "fixed";
  json["rate_hz"] = run.rateHz;
  json["motion"] = run.motion;
  json["ground_truth"] = run.groundTruth;
  if (!run.repeatOf.empty()) json["repeat_of"] = run.repeatOf;
  if (run.linearCommands) json["hold"] = "linear";
  if (run.heading) json["heading"] = *run.heading;
  if (!run.unsignedKinds.empty()) json["unsigned"] = run.unsignedKinds;
  for (const auto& [joint, servo] : run.servo) json["servo"][joint] = servoJson(servo);
  for (const auto& [key, field] : timingKeys) {
    if (run.timing.size() == 1 && run.timing.count("*"))
      json["timing"][key] = run.timing.at("*").*field;
    else
      for (const auto& [joint, timing] : run.timing)
        if (joint != "*") json["timing"][key][joint] = timing.*field;
  }
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// The columns in the format's order: commands, positions, ...
std::vector<std::string> columnOrder(const Run& run) {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(ChannelKind::truth); ++kind)
    for (const auto& [name, column] : run.channels)
      if (const auto channel = parseChannel(name); channel && static_cast<int>(channel->kind) == kind)
        names.push_back(name);
  return names;
}

void appendNumber(std::string& text, double x, int digits) {
  if (std::isnan(x)) return;
  char buffer[40];
  text.append(buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, "%.*g", digits, x)));
}

std::string tableText(const Run& run, int digits) {
  const std::vector<std::string> names = columnOrder(run);
  std::string text = "t";
  std::vector<const std::vector<double>*> columns;
  for (const std::string& name : names) {
    text += "," + name;
    columns.push_back(run.find(name));
    if (columns.back()->size() != run.size()) throw RunError(name + ": another length than t");
  }
  text += "\n";
  for (std::size_t i = 0; i < run.size(); ++i) {
    appendNumber(text, run.t[i], digits + 2);
    for (const std::vector<double>* column : columns) {
      text += ',';
      appendNumber(text, (*column)[i], digits);
    }
    text += '\n';
  }
  return text;
}

bool writePacked(const fs::path& path, const std::string& text) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "wb9"),
                                                        [](gzFile) { return 0; });
  if (!file) return false;
  constexpr std::size_t piece = 1 << 20;
  bool good = true;
  for (std::size_t at = 0; at < text.size() && good; at += piece) {
    const std::size_t size = std::min(piece, text.size() - at);
    good = gzwrite(file.get(), text.data() + at, static_cast<unsigned>(size)) == static_cast<int>(size);
  }
  return gzclose(file.get()) == Z_OK && good;
}

bool writePlain(const fs::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return static_cast<bool>(stream);
}

}  // namespace

void writeRun(const Run& run, const std::string& folder, WriteRunOptions options) {
  const std::string table = tableText(run, options.digits), meta = metaText(run);
  std::string name = folder;
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  const fs::path place(name), partial(name + ".part");
  std::error_code error;
  if (fs::exists(place, error)) throw RunError(name + ": exists already; remove it or choose another folder");
  fs::remove_all(partial, error);
  PartialFolder part(partial);
  fs::create_directories(partial, error);
  const bool good = !error && writePlain(partial / "run.json", meta) &&
                    (options.packed ? writePacked(partial / "run.csv.gz", table)
                                    : writePlain(partial / "run.csv", table)) &&
                    syncToDisk((partial / "run.json").string()) &&
                    syncToDisk((partial / (options.packed ? "run.csv.gz" : "run.csv")).string()) &&
                    syncToDisk(partial.string());
  if (good) fs::rename(partial, place, error);
  if (!good || error)
    throw RunError(name + ": cannot be written: " + (error ? error.message() : std::strerror(errno)));
  part.keep();
}

}  // namespace plumbline::gap
