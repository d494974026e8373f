#include "tunnel/RankCommand.h"

#include <csignal>

namespace plumbline::tunnel {
namespace {

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

RankCommand::RankCommand(std::vector<std::string> command, int port, int rank)
    : command_(std::move(command)),
      settings_{
          .environment = {"MPITUNNEL_PORT=" + std::to_string(port), "MPITUNNEL_RANK=" + std::to_string(rank)},
          .dropped = {"OMPI_", "PMIX_", "PMI_", "ORTE_"},
          .onPath = true,
          .wholeGroup = true} {
  for (std::string& argument : command_) {
    replaceAll(argument, "{port}", std::to_string(port));
    replaceAll(argument, "{rank}", std::to_string(rank));
  }
}

void RankCommand::start() { child_ = std::make_unique<simspark::ChildProcess>(command_, settings_); }

std::optional<int> RankCommand::status() {
  if (child_) child_->running();
  return child_ ? child_->exitStatus() : std::nullopt;
}

void RankCommand::terminate() {
  if (child_) child_->signalGroup(SIGTERM);
}

void RankCommand::stop(double patience) {
  if (child_) child_->stop(patience);
}

}  // namespace plumbline::tunnel
