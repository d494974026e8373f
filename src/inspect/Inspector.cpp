#include "inspect/Inspector.h"

#include <algorithm>
#include <cstdio>

#include "framework/NearestName.h"

namespace plumbline::inspect {
namespace {

using Verb = Command::Verb;

constexpr std::size_t maxNameLength = 300;

bool matches(const std::string& part, const std::string& wanted) { return wanted.empty() || part == wanted; }

}  // namespace

Inspector::Inspector(AgentDebug& agent, DebugPoints& sites) : agent_(agent), sites_(sites) {}

Inspector::~Inspector() {
  while (!pending_.empty()) remove(pending_.begin()->first);
  agent_.setWatched(false);
}

int Inspector::open(Send send) {
  agent_.setWatched(true);
  clients_[nextClient_] = {std::move(send), false, 0};
  return nextClient_++;
}

void Inspector::close(int client) {
  clients_.erase(client);
  std::vector<std::uint64_t> ended;
  for (auto& [number, pending] : pending_) {
    if (pending.client != client) continue;
    pending.client = -1;
    if (pending.use != Use::set && pending.use != Use::run) ended.push_back(number);
  }
  for (const std::uint64_t number : ended) remove(number);
  agent_.setWatched(!clients_.empty() || !pending_.empty());
}

std::vector<DebugPoints::Info> Inspector::all() const {
  std::vector<DebugPoints::Info> result = agent_.points.list();
  for (auto& site : sites_.list()) result.push_back(std::move(site));
  for (const auto& [id, stopwatch] : agent_.stopwatches()) result.push_back({id, DebugKind::timing});
  std::ranges::sort(result, {}, &DebugPoints::Info::id);
  return result;
}

std::optional<Inspector::Target> Inspector::find(const std::string& name, std::string& error) const {
  if (name.size() > maxNameLength) {
    error = "a name is longer than " + std::to_string(maxNameLength) + " characters";
    return std::nullopt;
  }
  const auto stopwatches =
      name.starts_with("timing:") ? agent_.stopwatches() : decltype(agent_.stopwatches()){};
  // The longest id that the name begins with; the rest is a part.
  for (std::size_t end = name.size(); end != std::string::npos && end > 0;
       end = name.find_last_of(".[", end - 1)) {
    Target target{name, name.substr(0, end), name.substr(end)};
    for (DebugPoints* points : {&agent_.points, &sites_}) {
      const auto kind = points->find(target.id);
      if (!kind) continue;
      target.kind = *kind;
      target.points = points;
      return target;
    }
    if (const auto found = stopwatches.find(target.id); found != stopwatches.end()) {
      target.kind = DebugKind::timing;
      target.stopwatch = found->second;
      return target;
    }
  }
  std::vector<std::string> names;
  for (auto& info : all()) names.push_back(std::move(info.id));
  error = "nothing is called " + name + suggestion(name, names);
  return std::nullopt;
}

void Inspector::command(int client, std::string_view text) {
  if (!clients_.contains(client)) return;
  const Command command = parseCommand(text);
  if (!command.error.empty()) return fail(client, command.tag, command.error);
  switch (command.verb) {
    case Verb::get:
      return read(client, command, Use::get);
    case Verb::watch:
      return read(client, command, Use::watch);
    case Verb::unwatch:
      return unwatch(client, command);
    case Verb::set:
    case Verb::setOnce:
      return set(client, command);
    case Verb::unset:
      return unset(client, command);
    case Verb::run:
    case Verb::runOnce:
    case Verb::runOff:
      return run(client, command);
    case Verb::list:
      return list(client, command);
    case Verb::complete:
      return complete(client, command);
    case Verb::timing:
      return timing(client, command);
    case Verb::graph:
      return graph(client, command);
    case Verb::about:
      return about(client, command);
    case Verb::providers:
      return providers(client, command);
    case Verb::format:
      clients_[client].json = command.name == "json";
      return succeed(client, command.tag);
    case Verb::help:
      return help(client, command);
    case Verb::commands:
      return commands(client, command);
    case Verb::none:
      return;
  }
}

void Inspector::start(Pending pending,
                      const std::function<std::shared_ptr<DebugRequest>(std::uint64_t)>& make) {
  Client& client = clients_[pending.client];
  const auto set = static_cast<std::size_t>(std::ranges::count_if(pending_, [](const auto& entry) {
    return entry.second.use == Use::set || entry.second.use == Use::run;
  }));
  if (client.open >= maxPerClient || set >= maxSet)
    return fail(pending.client, pending.tag, "too many requests at once");
  ++client.open;
  const std::uint64_t number = ++nextRequest_;
  pending.deadline = Clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * patience));
  if (make) pending.request = make(number);
  if (pending.use == Use::watch) pending.reads = std::dynamic_pointer_cast<ReadRequest>(pending.request);
  const auto added = pending_.emplace(number, std::move(pending)).first;
  const Target& target = added->second.target;
  if (target.points && added->second.request) target.points->attach(target.id, added->second.request);
}

void Inspector::remove(std::uint64_t number) {
  const auto found = pending_.find(number);
  if (found == pending_.end()) return;
  const Pending& pending = found->second;
  if (pending.target.points && pending.request)
    pending.target.points->detach(pending.target.id, pending.request);
  if (const auto client = clients_.find(pending.client); client != clients_.end()) --client->second.open;
  const bool hides = pending.use == Use::run && pending.target.kind == DebugKind::drawing && !pending.once;
  const std::string id = pending.target.id;
  pending_.erase(found);
  if (hides) show_(id, {});
}

void Inspector::read(int client, const Command& command, Use use) {
  std::string error;
  auto target = find(command.name, error);
  if (!target) return fail(client, command.tag, error);
  if (target->kind == DebugKind::code || target->kind == DebugKind::codeOnce)
    return fail(client, command.tag, target->id + " is a block of code, not a value: dr " + target->id);
  const bool once = use != Use::watch;
  Pending pending{client, command.tag, *target, use, once};
  pending.interval = command.interval;
  start(std::move(pending), target->points ? [&](std::uint64_t number) -> std::shared_ptr<DebugRequest> {
    return std::make_shared<ReadRequest>(number, outbox_, once, command.interval);
  } : std::function<std::shared_ptr<DebugRequest>(std::uint64_t)>());
  if (!target->points) readStopwatches(Clock::now());
}

void Inspector::set(int client, const Command& command) {
  std::string error;
  auto target = find(command.name, error);
  if (!target) return fail(client, command.tag, error);
  if (target->kind != DebugKind::modify && target->kind != DebugKind::parameter)
    return fail(client, command.tag,
                target->id + " cannot be set: its kind is " + std::string(nameOf(target->kind)));
  std::string before;
  for (auto at = pending_.begin(); at != pending_.end();) {
    const auto [number, pending] = *at++;
    if (pending.use != Use::set || pending.target.name != target->name) continue;
    before = pending.before;
    if (!pending.answered)
      fail(pending.client, pending.tag, target->name + ": another set came before the next cycle");
    remove(number);
  }
  const bool once = target->kind == DebugKind::parameter || command.verb == Verb::setOnce;
  Pending pending{client, command.tag, *target, Use::set, command.verb == Verb::setOnce};
  pending.before = before;
  start(std::move(pending), [&](std::uint64_t number) -> std::shared_ptr<DebugRequest> {
    return std::make_shared<SetRequest>(number, outbox_, once, target->part, command.value);
  });
}

void Inspector::unset(int client, const Command& command) {
  std::string error;
  const auto target = find(command.name, error);
  if (!target) return fail(client, command.tag, error);
  bool any = false;
  std::vector<Pending> restored;
  for (auto at = pending_.begin(); at != pending_.end();) {
    const auto number = at->first;
    const Pending& pending = (at++)->second;
    if (pending.use != Use::set || pending.target.id != target->id ||
        !matches(pending.target.part, target->part))
      continue;
    any = true;
    if (!pending.answered)
      fail(pending.client, pending.tag, pending.target.name + ": unset came before the next cycle");
    if (target->kind == DebugKind::parameter && !pending.before.empty()) restored.push_back(pending);
    remove(number);
  }
  if (!any) return fail(client, command.tag, command.name + " is not set");
  for (const Pending& old : restored) {
    Tree value;
    parseTree(old.before, value);
    start({client, "", old.target, Use::set, true, true},
          [&](std::uint64_t number) -> std::shared_ptr<DebugRequest> {
            return std::make_shared<SetRequest>(number, outbox_, true, old.target.part, value);
          });
  }
  succeed(client, command.tag);
}

void Inspector::run(int client, const Command& command) {
  std::string error;
  const auto target = find(command.name, error);
  if (!target) return fail(client, command.tag, error);
  const bool draws = target->kind == DebugKind::drawing;
  if (target->kind != DebugKind::code && target->kind != DebugKind::codeOnce && !draws)
    return fail(client, command.tag, target->id + " is a value, not a block of code: get " + target->id);
  if (draws && !show_)
    return fail(client, command.tag, target->id + " has no viewer here; it can be watched");
  bool any = false;
  for (auto at = pending_.begin(); at != pending_.end();) {
    const auto number = at->first;
    const Pending& pending = (at++)->second;
    if (pending.use != Use::run || pending.target.id != target->id) continue;
    any = true;
    if (!pending.tag.empty()) finish(pending.client, pending.tag);
    remove(number);
  }
  if (command.verb == Verb::runOff) {
    return any ? succeed(client, command.tag) : fail(client, command.tag, target->id + " is not on");
  }
  const bool once = command.verb == Verb::runOnce || target->kind == DebugKind::codeOnce;
  // A block may still have output when it is switched off, a drawing not.
  if (!once) draws ? succeed(client, command.tag) : acknowledge(client, command.tag);
  start({client, draws && !once ? "" : command.tag, *target, Use::run, once, !once},
        [&](std::uint64_t number) -> std::shared_ptr<DebugRequest> {
          if (draws) return std::make_shared<DrawRequest>(number, outbox_, once);
          return std::make_shared<RunRequest>(number, outbox_, once);
        });
}

void Inspector::unwatch(int client, const Command& command) {
  bool any = false;
  for (auto at = pending_.begin(); at != pending_.end();) {
    const auto number = at->first;
    const Pending& pending = (at++)->second;
    if (pending.client != client || pending.use != Use::watch) continue;
    if (!command.name.empty() && pending.target.name != command.name) continue;
    any = true;
    if (!pending.tag.empty()) finish(client, pending.tag);
    remove(number);
  }
  if (!any && !command.name.empty()) return fail(client, command.tag, command.name + " is not watched");
  succeed(client, command.tag);
}

}  // namespace plumbline::inspect
