#include "simulation/server/AgentPort.h"

#include <algorithm>
#include <utility>

#include "framework/Loopback.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::simulation {

namespace {
constexpr std::size_t mostUnread = 1 << 20;  ///< bytes an agent may leave unread
constexpr std::size_t maxAgents = 64;        ///< connections at once
constexpr std::size_t maxPending = 256;      ///< messages in one cycle
// As on the league's server, the simulator does not wait for an agent that has never sent (syn) after this
// many messages. Before the first message it gets a moment, in which it can send it.
constexpr int unsyncedCycles = 5;
constexpr double unsyncedPatience = 0.5;
constexpr std::string_view hetero = "rsg/agent/nao/nao_hetero.rsg", standard = "rsg/agent/nao/nao.rsg";
}  // namespace

AgentPort::Agent::Agent(int fd, const std::string& address)
    : client(fd, address, simspark::maxAgentMessage, mostUnread) {}

AgentPort::AgentPort(const Config& config, Simulation& simulation, LogFunction log)
    : config_(config),
      simulation_(simulation),
      log_(std::move(log)),
      listener_(config_.address, config_.port) {}

void AgentPort::watch(std::vector<pollfd>& descriptors) {
  descriptors.push_back({listener_.descriptor(), POLLIN, 0});
  for (const auto& agent : agents_) descriptors.push_back(agent->client.watch());
  watched_ = agents_.size();
}

void AgentPort::serve(const pollfd* events) {
  for (std::size_t i = 0; i < watched_; ++i) {
    Agent& agent = *agents_[i];
    if (events[1 + i].revents == 0) continue;
    agent.client.serve(events[1 + i].revents);
    receive(agent);
  }
  if (events[0].revents != 0) accept();
}

void AgentPort::accept() {
  std::string address;
  for (std::size_t i = 0; i < mostAccepted; ++i) {
    const int fd = listener_.accept(address);
    if (fd < 0) return;
    agents_.push_back(std::make_unique<Agent>(fd, address));
    agents_.back()->admitted = config_.token.empty();
    makeRoom(
        agents_, maxAgents, "too many agents", [this](Agent& agent) { receive(agent); },
        [](const Agent& agent) { return !agent.sceneAsked; });
  }
}

void AgentPort::receive(Agent& agent) {
  for (std::string_view text; agent.client.next(text);) {
    if (!agent.admitted) {
      agent.admitted = sameSecret(text, "(token " + config_.token + ")");
      if (!agent.admitted) return agent.client.drop("did not name the token");
      continue;
    }
    simspark::AgentCommand command;
    const std::string problem = agent.parser.parse(text, command);
    if (!agent.parser.wellFormed()) return agent.client.drop("sent garbage: " + problem);
    if (!problem.empty()) complain(agent, problem);
    if (agent.pending.size() >= maxPending) return agent.client.drop("sent too many messages in a cycle");
    if (command.scene && !agent.sceneAsked) {
      agent.sceneAsked = true;
      agent.waitingSince = steadySeconds();
    }
    if (command.syn) agent.synced = agent.everSynced = true;
    agent.pending.push_back(std::move(command));
  }
}

int AgentPort::numAgents() const {
  return static_cast<int>(std::count_if(agents_.begin(), agents_.end(), [](const auto& agent) {
    return agent->sceneAsked && !agent->client.broken();
  }));
}

bool AgentPort::ready(const Agent& agent) const {
  if (!config_.sync || !agent.sceneAsked || agent.synced || agent.client.broken()) return true;
  if (agent.everSynced || agent.cycles >= unsyncedCycles) return false;
  return steadySeconds() - agent.waitingSince > unsyncedPatience;
}

bool AgentPort::ready() const {
  return std::all_of(agents_.begin(), agents_.end(), [this](const auto& agent) { return ready(*agent); });
}

void AgentPort::carryOut() {
  for (const auto& agent : agents_) {
    const bool mindful = !std::exchange(agent->answersPast, false);
    for (const simspark::AgentCommand& command : agent->pending)
      if (mindful && !agent->client.broken()) carryOut(*agent, command);
    agent->pending.clear();
    agent->synced = false;
  }
}

void AgentPort::carryOut(Agent& agent, const simspark::AgentCommand& command) {
  if (command.scene && !agent.player) {
    if ((command.scene->file != hetero && command.scene->file != standard) || command.scene->type < 0 ||
        command.scene->type >= numSimsparkTypes())
      return agent.client.drop("requested an unknown robot type: " + command.scene->file.substr(0, 80) + ' ' +
                               std::to_string(command.scene->type) + "; there is " + std::string(hetero) +
                               " 0.." + std::to_string(numSimsparkTypes() - 1));
    agent.player = simulation_.addPlayer(command.scene->type);
  }
  if (!agent.player) return;  // nothing to command yet
  const std::string problem = simulation_.act(*agent.player, command);
  if (!problem.empty()) complain(agent, problem);
  if (command.init && problem.empty()) log_(describe(agent) + " plays");
}

void AgentPort::restarted(const std::map<PlayerId, PlayerId>& ids) {
  for (const auto& agent : agents_) {
    const auto id = agent->player ? ids.find(*agent->player) : ids.end();
    if (id == ids.end()) continue;
    agent->player = id->second;
    agent->answersPast = true;
  }
}

void AgentPort::sendSenses() {
  for (const auto& agent : agents_) {
    if (!agent->player || agent->client.broken()) continue;
    const std::string& message = simulation_.message(*agent->player);
    agent->cycles = std::min(agent->cycles + 1, unsyncedCycles);
    agent->waitingSince = config_.sync ? steadySeconds() : 0;
    if (message.empty())
      agent->synced = true;  // it has nothing to answer
    else
      agent->client.send(message);
  }
}

void AgentPort::dropBroken() {
  for (const PlayerId id : simulation_.takeKilled())
    for (const auto& agent : agents_)
      if (agent->player == id) {
        agent->client.drop("removed by a trainer");
        agent->player.reset();
      }
  const double now = steadySeconds();
  for (const auto& agent : agents_) {
    if (agent->client.halfSince() > 0 && now - agent->client.halfSince() > config_.halfTimeout)
      agent->client.drop("sent half a message and no more");
    if (!agent->sceneAsked && now - agent->client.since() > config_.sceneTimeout)
      agent->client.drop("asked for no robot");
    if (config_.sync && config_.syncTimeout > 0 && !ready(*agent) &&
        now - agent->waitingSince > config_.syncTimeout)
      agent->client.drop("kept everybody waiting: no (syn) for " +
                         std::to_string(static_cast<int>(config_.syncTimeout)) + " s");
  }
  std::erase_if(agents_, [this](const auto& agent) {
    if (!agent->client.broken()) return false;
    log_(describe(*agent) + ' ' + agent->client.reason());
    if (agent->player) simulation_.removePlayer(*agent->player);
    return true;
  });
}

std::string AgentPort::describe(const Agent& agent) const {
  std::string text = "agent " + agent.client.address();
  if (!agent.player) return text;
  const auto player = simulation_.allPlayers().find(*agent.player);
  if (player == simulation_.allPlayers().end() || player->second->side == TeamSide::none) return text;
  return text + " (" + simulation_.game().teams[Game::index(player->second->side)] + ' ' +
         std::to_string(player->second->unum) + ')';
}

void AgentPort::complain(Agent& agent, const std::string& problem) {
  if (agent.complained) return;
  agent.complained = true;
  log_(describe(agent) + ": " + problem + " (reported once)");
}

}  // namespace plumbline::simulation
