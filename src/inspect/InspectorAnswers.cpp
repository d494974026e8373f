// Answers of an Inspector: its own, and those of the agent's threads.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/TextStream.h"
#include "inspect/Inspector.h"

namespace plumbline::inspect {
namespace {

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Microseconds.
struct StopwatchValue {
  std::uint64_t count;
  double min, mean, median, p99, max;
  void stream(InStream* in, OutStream* out) {
    STREAM(count);
    STREAM(min);
    STREAM(mean);
    STREAM(median);
    STREAM(p99);
    STREAM(max);
  }
};

std::string stopwatchText(const Stopwatch& watch) {
  const auto us = [](double seconds) { return std::round(1e9 * seconds) / 1e3; };
  return toText(StopwatchValue{watch.count(), us(watch.min()), us(watch.mean()), us(watch.percentile(0.5)),
                               us(watch.percentile(0.99)), us(watch.max())});
}

}  // namespace

bool Inspector::line(int client, const std::string& tag, const std::string& text, bool droppable) {
  const auto found = clients_.find(client);
  return found == clients_.end() ||
         found->second.send(tag.empty() ? text : '#' + tag + ' ' + text, droppable);
}

void Inspector::say(int client, const std::string& tag, std::string_view key, const std::string& text) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  line(client, tag, found->second.json ? jsonText({{std::string(key), text}}) : text);
}

void Inspector::finish(int client, const std::string& tag) {
  if (!tag.empty()) line(client, tag, ".");
}

void Inspector::fail(int client, const std::string& tag, const std::string& error) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  line(client, tag, found->second.json ? jsonText({{"error", error}}) : "error: " + error);
  finish(client, tag);
}

void Inspector::acknowledge(int client, const std::string& tag) {
  const auto found = clients_.find(client);
  if (found != clients_.end()) line(client, tag, found->second.json ? jsonText({{"ok", true}}) : "ok");
}

void Inspector::succeed(int client, const std::string& tag) {
  acknowledge(client, tag);
  finish(client, tag);
}

void Inspector::list(int client, const Command& command) {
  const bool json = clients_[client].json;
  for (const DebugPoints::Info& info : all()) {
    if (!info.id.starts_with(command.name)) continue;
    const std::string kind(nameOf(info.kind));
    bool isSet = false;
    for (const auto& [number, pending] : pending_)
      isSet = isSet || ((pending.use == Use::set || pending.use == Use::run) && pending.target.id == info.id);
    if (json) {
      line(client, command.tag, jsonText({{"id", info.id}, {"kind", kind}, {"held", isSet}}));
    } else {
      const bool code =
          info.kind == DebugKind::code || info.kind == DebugKind::codeOnce || info.kind == DebugKind::drawing;
      line(client, command.tag, info.id + "  " + kind + (isSet ? code ? ", on" : ", set" : ""));
    }
  }
  succeed(client, command.tag);
}

void Inspector::providers(int client, const Command& command) {
  const bool json = clients_[client].json;
  for (const AgentDebug::Provision& provision : agent_.provisions()) {
    if (!provision.representation.starts_with(command.name)) continue;
    bool set = false;
    for (const auto& [number, pending] : pending_)
      set = set ||
            (pending.use == Use::set && pending.target.id == "representation:" + provision.representation);
    if (json)
      line(client, command.tag,
           jsonText({{"representation", provision.representation},
                     {"provider", provision.provider},
                     {"thread", provision.thread},
                     {"set", set}}));
    else
      line(client, command.tag,
           provision.representation + "  " + provision.provider + "  [" + provision.thread + "]" +
               (set ? ", set from outside" : ""));
  }
  succeed(client, command.tag);
}

void Inspector::value(std::uint64_t number, Pending& pending, const std::string& text) {
  const auto client = clients_.find(pending.client);
  if (client == clients_.end()) return;
  const bool once = pending.use != Use::watch;
  Tree tree;
  std::string error = parseTree(text, tree);
  if (pending.use == Use::complete) {
    const auto cut = pending.target.name.find_last_of(".[");
    const std::string stem = pending.target.name.substr(0, cut), prefix = pending.target.name.substr(cut);
    Tree* part = stem.size() < pending.target.id.size()
                     ? nullptr
                     : findPart(tree, std::string_view(stem).substr(pending.target.id.size()), error);
    if (part) {
      for (const std::string& path : partPaths(*part, maxCompletions)) {
        if (path.starts_with(prefix)) say(pending.client, pending.tag, "completion", stem + path);
      }
    }
    finish(pending.client, pending.tag);
    return remove(number);
  }
  const Tree* part = error.empty() ? findPart(tree, pending.target.part, error) : nullptr;
  if (!part) {
    fail(pending.client, pending.tag, pending.target.id + error);
    return remove(number);
  }
  bool sent = true;
  if (client->second.json) {
    const nlohmann::ordered_json json{{"id", pending.target.name}, {"value", treeJson(*part)}};
    sent = line(pending.client, pending.tag, jsonText(json), !once);
  } else {
    sent = line(pending.client, pending.tag, pending.target.name + ' ' + treeText(*part), !once);
  }
  // What nobody reads costs the agent's threads little.
  if (!sent && pending.reads) pending.reads->pause(slowPause);
  if (!once) return;
  finish(pending.client, pending.tag);
  remove(number);
}

void Inspector::outcome(const Outcome& outcome) {
  const auto found = pending_.find(outcome.request);
  if (found == pending_.end()) return;
  Pending& pending = found->second;
  const bool first = !pending.answered;
  if (outcome.kind == Outcome::Kind::error) {
    fail(pending.client, first ? pending.tag : "", pending.target.id + outcome.text);
    return remove(outcome.request);
  }
  if (outcome.drawing) return show_(pending.target.id, *outcome.drawing);
  if (pending.use == Use::run && outcome.kind == Outcome::Kind::value) {
    const auto client = clients_.find(pending.client);
    if (client == clients_.end()) return;
    std::string text = outcome.text;
    std::ranges::replace(text, '\n', ' ');
    line(pending.client, pending.tag,
         client->second.json ? jsonText({{"id", pending.target.id}, {"text", text}})
                             : pending.target.id + ' ' + text,
         !pending.once);
    return;
  }
  if (outcome.kind == Outcome::Kind::value) return value(outcome.request, pending, outcome.text);
  pending.answered = true;
  if (pending.use == Use::set && pending.before.empty()) pending.before = outcome.text;
  if (first) succeed(pending.client, pending.tag);
  if (pending.once && !(pending.use == Use::set && pending.target.kind == DebugKind::parameter && first))
    remove(outcome.request);
}

void Inspector::readStopwatches(Clock::time_point now) {
  std::vector<std::uint64_t> due;
  for (const auto& [number, pending] : pending_) {
    if (!pending.target.stopwatch) continue;
    if (pending.use == Use::watch && pending.answered && now < pending.deadline) continue;
    due.push_back(number);
  }
  for (const std::uint64_t number : due) {
    Pending& pending = pending_.at(number);
    // A stopwatch belongs to no cycle: a person can follow half a second.
    const double interval = pending.interval.seconds > 0 ? pending.interval.seconds : 0.5;
    pending.answered = true;
    pending.deadline = now + std::chrono::milliseconds(static_cast<int>(1000 * interval));
    value(number, pending, stopwatchText(*pending.target.stopwatch));
  }
}

void Inspector::poll(Clock::time_point now) {
  for (const Outcome& said : outbox_->take()) outcome(said);
  readStopwatches(now);
  std::vector<std::uint64_t> late;
  for (const auto& [number, pending] : pending_) {
    const bool waits = !pending.answered && pending.use != Use::watch && !pending.target.stopwatch;
    if (waits && now > pending.deadline) late.push_back(number);
  }
  for (const std::uint64_t number : late) {
    const Pending& pending = pending_.at(number);
    fail(pending.client, pending.tag,
         pending.target.id +
             ": the code did not reach this point within 2 s; does the agent wait for its simulator?");
    remove(number);
  }
  if (clients_.empty() && pending_.empty()) agent_.setWatched(false);
}

}  // namespace plumbline::inspect
