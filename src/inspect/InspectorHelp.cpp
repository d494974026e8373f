// Help for a person who types: commands, the arguments of each, and the table of times.
#include <algorithm>
#include <set>

#include "framework/NearestName.h"
#include "inspect/Inspector.h"

namespace plumbline::inspect {
namespace {

constexpr std::string_view resetPrefix = "reset:", reloadPrefix = "reload:", timingPrefix = "timing:";

template <typename Each>
void eachLine(std::string_view text, Each&& each) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    each(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

bool isBlock(DebugKind kind) { return kind == DebugKind::code || kind == DebugKind::codeOnce; }

/// Whether a command takes what has this name and kind; only those arguments that are names of points.
bool takes(Argument argument, const DebugPoints::Info& info) {
  const bool command = info.id.starts_with(resetPrefix) || info.id.starts_with(reloadPrefix);
  switch (argument) {
    case Argument::name:
      return true;
    case Argument::value:
      return !isBlock(info.kind);
    case Argument::settable:
      return info.kind == DebugKind::modify || info.kind == DebugKind::parameter;
    case Argument::block:
      return (isBlock(info.kind) && !command) || info.kind == DebugKind::drawing;
    case Argument::parameter:
      return info.kind == DebugKind::parameter;
    default:
      return false;
  }
}

}  // namespace

std::vector<std::string> Inspector::candidates(int client, Argument argument) const {
  std::set<std::string> found;  // sorted, each once
  for (const DebugPoints::Info& info : all()) {
    if (takes(argument, info)) found.insert(info.id);
    for (const auto& [wanted, prefix] : {std::pair(Argument::module, resetPrefix),
                                         {Argument::file, reloadPrefix},
                                         {Argument::stopwatch, timingPrefix}}) {
      if (argument == wanted && info.id.starts_with(prefix)) found.insert(info.id.substr(prefix.size()));
    }
  }
  for (const auto& [number, pending] : pending_) {
    if ((argument == Argument::pending && pending.use == Use::set) ||
        (argument == Argument::watched && pending.use == Use::watch && pending.client == client))
      found.insert(pending.target.name);
  }
  if (argument == Argument::representation) {
    for (const AgentDebug::Provision& provision : agent_.provisions()) found.insert(provision.representation);
  }
  if (argument == Argument::format) found = {"text", "json"};
  if (argument == Argument::command) {
    for (const CommandForm& form : commandForms()) found.emplace(form.word);
  }
  return {found.begin(), found.end()};
}

void Inspector::complete(int client, const Command& command) {
  const auto space = command.name.find(' ');
  const std::string word = command.name.substr(0, space);
  const auto form = std::ranges::find(commandForms(), word, &CommandForm::word);
  const bool any = form == commandForms().end();
  if (any && space != std::string::npos)
    return fail(client, command.tag, "complete [COMMAND] [PREFIX]: no command \"" + word.substr(0, 60) + '"');
  const Argument argument = any ? Argument::name : form->argument;
  Command rest = command;
  if (!any) rest.name = space == std::string::npos ? "" : command.name.substr(space + 1);
  std::size_t count = 0;
  for (const std::string& name : candidates(client, argument)) {
    if (name.starts_with(rest.name) && count++ < maxCompletions) say(client, command.tag, "completion", name);
  }
  const bool hasParts =
      argument == Argument::name || argument == Argument::value || argument == Argument::settable;
  const auto cut = rest.name.find_last_of(".[");
  std::string error;
  if (count == 0 && hasParts && cut != std::string::npos && find(rest.name.substr(0, cut), error))
    return read(client, rest, Use::complete);
  finish(client, command.tag);
}

void Inspector::commands(int client, const Command& command) {
  for (const CommandForm& form : commandForms()) say(client, command.tag, "command", std::string(form.usage));
  finish(client, command.tag);
}

void Inspector::help(int client, const Command& command) {
  bool any = false;
  eachLine(commandHelp(), [&](std::string_view line) {
    const std::string_view word = line.substr(0, line.find(' '));
    if (!command.name.empty() && word != command.name) return;
    any = true;
    say(client, command.tag, "help", std::string(line));
  });
  if (any) return finish(client, command.tag);
  const auto known = candidates(client, Argument::command);
  fail(client, command.tag,
       "no command \"" + command.name.substr(0, 60) + '"' + suggestion(command.name.substr(0, 60), known));
}

void Inspector::timing(int client, const Command& command) {
  std::string_view wanted = command.name;
  if (wanted.starts_with(timingPrefix)) wanted.remove_prefix(timingPrefix.size());
  bool any = false;
  std::vector<std::string> lines;
  const std::string report = agent_.timingReport();
  eachLine(report, [&](std::string_view line) {
    const bool head = line.starts_with('[') || line.starts_with("microseconds");
    const bool shown = line.substr(std::min(line.size(), line.find_first_not_of(' '))).starts_with(wanted);
    any = any || (shown && !head);
    if (head || shown) lines.emplace_back(line);
  });
  if (!any && !wanted.empty())
    return fail(client, command.tag,
                "no time has a name that begins with " + std::string(wanted.substr(0, 60)));
  for (const std::string& line : lines) say(client, command.tag, "timing", line);
  finish(client, command.tag);
}

}  // namespace plumbline::inspect
