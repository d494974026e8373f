#include "optimization/farm/FarmServer.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "framework/Loopback.h"

namespace plumbline::farm {
namespace {

using nlohmann::json;

constexpr double syncEvery = 1, farewell = 2;  // [s]
constexpr int tickMilliseconds = 100, clientsAtOnce = 256;
constexpr double forgetting = 0.01;  // of the mean of costs
constexpr std::size_t maxWaiting = 4 * maxLine;

}  // namespace

FarmServer::FarmServer(Search& search, Journal* journal, Welcome welcome, const FarmOptions& options)
    : search_(search),
      journal_(journal),
      welcome_(std::move(welcome)),
      options_(options),
      dispatcher_(search, options.dispatch,
                  [this](const Trial& trial, std::span<const double> costs, int worker) {
                    record(trial, costs, worker);
                  }) {
  if (options.token.empty() && !isLoopbackAddress(options.address))
    throw std::runtime_error("port " + options.address + ':' + std::to_string(options.port) +
                             " is open to others: that needs a token");
  listener_ = listenOn(options.address, options.port, port_);
}

FarmServer::~FarmServer() { ::close(listener_); }

void FarmServer::record(const Trial& trial, std::span<const double> costs, int worker) {
  if (journal_)
    journal_->add(trial, costs, worker < 0 ? std::map<std::string, double>{} : figures_,
                  worker < 0 ? "" : answerer_, worker < 0 ? 0 : answerSeconds_);
  if (onResult_) onResult_(costs);
  if (costs.empty()) return;
  ++progress_.trials;
  progress_.runs += static_cast<std::int64_t>(costs.size());
  const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
  if (!std::isfinite(mean)) return;
  const double share = std::max(forgetting, 1.0 / static_cast<double>(progress_.trials));
  progress_.lastCost += share * (mean - progress_.lastCost);
  for (const auto& [name, value] : figures_) {
    const auto [place, isNew] = progress_.figures.try_emplace(name, value);
    if (!isNew) place->second += share * (value - place->second);
  }
}

void FarmServer::accept() {
  for (int taken = 0; taken < clientsAtOnce; ++taken) {
    const int fd = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    // The system may allow fewer files than clients.
    if (fd < 0 && (errno == EMFILE || errno == ENFILE) && makeRoom()) continue;
    if (fd < 0) return;
    const bool hasRoom = clients_.size() < options_.maxClients || makeRoom();
    Client& client = clients_.emplace_back(Client{LineSocket(fd, maxLine, maxWaiting), now()});
    if (!hasRoom) refuse(client, "too many clients: " + std::to_string(options_.maxClients) + " are there");
  }
}

bool FarmServer::makeRoom() {
  // In the order in which they came.
  for (auto client = clients_.begin(); client != clients_.end(); ++client) {
    if (client->worker >= 0 || client->ends) continue;
    // It may have spoken since it was last listened to.
    client->socket.serve(POLLIN);
    takeLines(*client);
    if (client->worker >= 0 || client->ends) continue;
    refuse(*client, "you have said nothing, and others need the place");
    clients_.erase(client);
    return true;
  }
  return false;
}

void FarmServer::refuse(Client& client, const std::string& why) {
  client.socket.send(json{{"error", why}}.dump());
  client.ends = true;
  ++progress_.dropped;
}

void FarmServer::hello(Client& client, const std::string& line) {
  const Hello hello = readHello(line);
  if (!sameSecret(hello.token, options_.token)) return refuse(client, "the token is wrong or missing");
  if (hello.role == Hello::Role::status) {
    client.socket.send(status());
    client.ends = true;
    return;
  }
  client.worker = dispatcher_.join();
  client.name = hello.name.empty() ? "worker " + std::to_string(client.worker) : hello.name;
  client.socket.send(text(welcome_));
}

void FarmServer::answer(Client& client, const std::string& line) {
  const Answer answer = readAnswer(line);
  figures_ = answer.figures;
  answerer_ = client.name;
  answerSeconds_ = now() - client.gaveAt;
  if (dispatcher_.take(client.worker, answer.number, answer.costs) == Taken::wrong)
    return refuse(client, "answer: " + std::to_string(answer.costs.size()) + " costs for trial " +
                              std::to_string(answer.number) +
                              "; answer the trial that was sent, with one cost for each run");
  client.works = false;
  ++client.answers;
  progress_.busySeconds += answerSeconds_;
}

void FarmServer::takeLines(Client& client) {
  std::string line;
  while (!client.ends && client.socket.next(line)) {
    try {
      if (client.worker < 0)
        hello(client, line);
      else
        answer(client, line);
    } catch (const std::invalid_argument& error) {
      refuse(client, error.what());
    }
  }
}

void FarmServer::giveWork() {
  for (Client& client : clients_) {
    if (client.worker < 0 || client.works || client.ends || client.socket.broken()) continue;
    if (search_.isDone()) {
      client.socket.send(json{{"over", "the search is over"}}.dump());
      client.ends = true;
      continue;
    }
    const std::optional<Trial> trial = dispatcher_.give(client.worker, now());
    if (!trial) return;
    client.works = true;
    client.gaveAt = now();
    client.socket.send(text(*trial));
  }
}

void FarmServer::sweep() {
  for (auto client = clients_.begin(); client != clients_.end();) {
    const bool silent = client->worker < 0 && now() - client->since > options_.helloPatience;
    if (!client->socket.broken() && !silent && !(client->ends && client->socket.sentAll())) {
      ++client;
      continue;
    }
    if (client->socket.broken() || silent) progress_.dropped += !client->ends;
    if (client->worker >= 0) dispatcher_.leave(client->worker);
    client = clients_.erase(client);
  }
}

bool FarmServer::serve(int stopDescriptor, const std::function<void()>& tick) {
  double doneAt = -1;
  for (;;) {
    std::vector<pollfd> watched{{stopDescriptor, POLLIN, 0}, {listener_, POLLIN, 0}};
    std::vector<Client*> of;
    for (Client& client : clients_) {
      watched.push_back({client.socket.descriptor(), client.socket.events(), 0});
      of.push_back(&client);
    }
    poll(watched.data(), watched.size(), tickMilliseconds);
    if (watched[0].revents) return false;
    for (std::size_t i = 0; i < of.size(); ++i) {
      of[i]->socket.serve(watched[i + 2].revents);
      takeLines(*of[i]);
    }
    if (watched[1].revents) accept();
    sweep();
    dispatcher_.expire(now());
    giveWork();
    progress_.seconds = now();
    if (journal_ && now() - synced_ > syncEvery) {
      journal_->sync();
      synced_ = now();
    }
    if (tick) tick();
    if (!search_.isDone()) continue;
    if (doneAt < 0) doneAt = now();
    if (clients_.empty() || now() - doneAt > farewell) return true;
  }
}

std::vector<WorkerReport> FarmServer::workerReports() const {
  std::vector<WorkerReport> reports;
  for (const Client& client : clients_)
    if (client.worker >= 0)
      reports.push_back({client.name, client.works, client.answers,
                         now() - (client.gaveAt > 0 ? client.gaveAt : client.since)});
  return reports;
}

std::string FarmServer::status() const {
  const Optimizer& optimizer = search_.optimizer();
  const DispatchCounts& counts = dispatcher_.counts();
  const auto number = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  json line{{"task", welcome_.task},
            {"generation", optimizer.generations()},
            {"best", number(optimizer.bestCost())},
            {"mean", number(progress_.lastCost)},
            {"sigma", number(optimizer.sigma())},
            {"trials", search_.trials()},
            {"runs", search_.runs()},
            {"runs_per_second",
             number(progress_.seconds > 0 ? static_cast<double>(progress_.runs) / progress_.seconds : 0)},
            {"workers", workers()},
            {"busy", busy()},
            {"not_numbers", search_.notNumbers()},
            {"given_up", search_.givenUp()},
            {"lost", counts.lost},
            {"hung", counts.hung},
            {"again", counts.again},
            {"dropped", progress_.dropped},
            {"seconds", number(progress_.seconds)},
            {"stop", search_.isDone() ? name(optimizer.stopReason()) : ""}};
  for (const auto& [name, value] : progress_.figures) line["figures"][name] = value;
  return line.dump();
}

}  // namespace plumbline::farm
