#include "inspect/Command.h"

#include <array>
#include <charconv>
#include <vector>

#include "framework/NearestName.h"

namespace plumbline::inspect {
namespace {

using Verb = Command::Verb;

constexpr std::size_t maxTag = 40;

constexpr std::array forms{
    CommandForm{"get", "get NAME", Argument::value, Verb::get, true},
    CommandForm{"watch", "watch NAME [every N | every SECONDSs]", Argument::value, Verb::watch, true},
    CommandForm{"unwatch", "unwatch [NAME]", Argument::watched, Verb::unwatch},
    CommandForm{"set", "set NAME VALUE", Argument::settable, Verb::set, true},
    CommandForm{"setOnce", "setOnce NAME VALUE", Argument::settable, Verb::setOnce, true},
    CommandForm{"unset", "unset NAME", Argument::pending, Verb::unset, true},
    CommandForm{"dr", "dr NAME [once | off]", Argument::block, Verb::run, true},
    CommandForm{"list", "list [PREFIX]", Argument::name, Verb::list},
    CommandForm{"complete", "complete [COMMAND] [PREFIX]", Argument::name, Verb::complete},
    CommandForm{"reset", "reset MODULE", Argument::module, Verb::run, true},
    CommandForm{"reload", "reload FILE", Argument::file, Verb::run, true},
    CommandForm{"providers", "providers [PREFIX]", Argument::representation, Verb::providers},
    CommandForm{"format", "format text|json", Argument::format, Verb::format, true},
    CommandForm{"timing", "timing [PREFIX]", Argument::stopwatch, Verb::timing},
    CommandForm{"graph", "graph", Argument::nothing, Verb::graph},
    CommandForm{"about", "about [PREFIX]", Argument::parameter, Verb::about},
    CommandForm{"commands", "commands", Argument::nothing, Verb::commands},
    CommandForm{"help", "help [COMMAND]", Argument::command, Verb::help},
};

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

/// Removes and returns the first word.
std::string_view word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view result = text.substr(0, text.find_first_of(" \t"));
  text = trimmed(text.substr(result.size()));
  return result;
}

std::string inQuotes(std::string_view text) { return '"' + std::string(text.substr(0, 60)) + '"'; }

std::string parseInterval(std::string_view text, Interval& interval) {
  if (text.empty()) return {};
  const std::string wrong =
      "watch NAME every N cycles or every SECONDSs, as 10 or 0.5s, not " + inQuotes(text);
  if (word(text) != "every") return wrong;
  const std::string_view number = word(text);
  if (number.empty() || !text.empty()) return wrong;
  const bool seconds = number.back() == 's';
  const char* last = number.data() + number.size() - (seconds ? 1 : 0);
  interval = {};
  if (seconds) {
    interval.cycles = 0;
    const auto read = std::from_chars(number.data(), last, interval.seconds);
    if (read.ec != std::errc{} || read.ptr != last || !(interval.seconds > 0 && interval.seconds <= 3600))
      return wrong;
  } else {
    const auto read = std::from_chars(number.data(), last, interval.cycles);
    if (read.ec != std::errc{} || read.ptr != last || interval.cycles == 0) return wrong;
  }
  return {};
}

std::string parseRest(Command& command, std::string_view rest) {
  switch (command.verb) {
    case Verb::watch:
      return parseInterval(rest, command.interval);
    case Verb::set:
    case Verb::setOnce: {
      if (rest.empty()) return "set NAME VALUE: the value is missing";
      const std::string error = parseTree(rest, command.value);
      return error.empty() ? "" : "the value: " + error;
    }
    case Verb::run:
      if (rest == "once") command.verb = Verb::runOnce;
      if (rest == "off") command.verb = Verb::runOff;
      if (!rest.empty() && command.verb == Verb::run) return "dr NAME [once | off], not " + inQuotes(rest);
      return {};
    case Verb::format:
      if (command.name != "text" && command.name != "json")
        return "format text|json, not " + inQuotes(command.name);
      [[fallthrough]];
    default:
      return rest.empty() ? "" : "too much: " + inQuotes(rest);
  }
}

}  // namespace

std::span<const CommandForm> commandForms() { return forms; }

Command parseCommand(std::string_view line) {
  Command command;
  line = trimmed(line);
  if (!line.empty() && line.front() == '#') {
    command.tag = word(line).substr(1, maxTag);
    if (command.tag.empty()) {
      command.error = "a tag is missing behind #";
      return command;
    }
  }
  const std::string_view verb = word(line);
  if (verb.empty()) return command;
  const CommandForm* found = nullptr;
  std::vector<std::string> words;
  for (const CommandForm& form : forms) {
    words.emplace_back(form.word);
    if (form.word == verb) found = &form;
  }
  if (!found) {
    command.error =
        "no command " + inQuotes(verb) + suggestion(verb.substr(0, 60), words) + " (help lists them)";
    return command;
  }
  command.verb = found->verb;
  if (command.verb == Verb::complete) {
    command.name = line;
    return command;
  }
  command.name = word(line);
  if (!command.name.empty() && found->argument == Argument::nothing) {
    command.error = std::string(verb) + " has nothing behind it";
    return command;
  }
  if (command.name.empty() && found->needsName) {
    command.error = std::string(found->usage) + ": the name is missing";
    return command;
  }
  // Blocks of code that every agent has.
  if (verb == "reset" || verb == "reload") {
    if (!line.empty()) {
      command.error = "too much: " + inQuotes(line);
      return command;
    }
    command.name = std::string(verb) + ':' + command.name;
  }
  command.error = parseRest(command, line);
  return command;
}

std::string_view commandHelp() {
  return "get NAME                    the value once; NAME may be a part: representation:BallPos.relative.x\n"
         "watch NAME [every N|every Ss]  the value each cycle, each N cycles or each S seconds\n"
         "unwatch [NAME]              no more of it; without a name: of all\n"
         "set NAME VALUE              overwrites it in each cycle until unset; a parameter: from now on\n"
         "setOnce NAME VALUE          overwrites it in the next cycle\n"
         "unset NAME                  ends set; a parameter gets the value it had before\n"
         "dr NAME [once|off]          switches a block of code or a drawing on, on for once, off\n"
         "list [PREFIX]               all names that begin so, and what each is\n"
         "complete [COMMAND] [PREFIX] how a name that begins so may go on: any, or those the command takes\n"
         "reset MODULE                restarts a module; parameters that were set keep their values\n"
         "reload FILE                 reads config/FILE.yaml again; if it has an error, the old one stays\n"
         "providers [PREFIX]          which module provides what now\n"
         "timing [PREFIX]             what each module takes, or those whose names begin so\n"
         "graph                       the modules by threads: what each provides, reads and takes\n"
         "about [PREFIX]              parameters whose names begin so: type, unit, range, what they do\n"
         "format text|json            how answers are written\n"
         "commands                    the commands, each with its arguments\n"
         "help [COMMAND]              this\n"
         "#TAG COMMAND                each line of the answer begins with #TAG, the last is \"#TAG .\"\n";
}

}  // namespace plumbline::inspect
