#pragma once
#include <poll.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::simulation {

constexpr double silentTimeout = 10;       ///< time for a client's first message [s of wall clock]
constexpr std::size_t mostAccepted = 256;  ///< connections taken in at once; the others wait for a cycle

/// Makes room on a port to which the last of `clients` has just connected. With more than `most`, the client
/// that has been silent longest is dropped, so that silent connections cannot block others. If all have sent
/// something, the newcomer is dropped. receive(client) reads what a client has sent, silent(client) says
/// whether it has sent nothing useful yet.
template <typename Client, typename Receive, typename Silent>
void makeRoom(std::vector<std::unique_ptr<Client>>& clients, std::size_t most, const std::string& tooMany,
              const Receive& receive, const Silent& silent) {
  const auto here = std::count_if(clients.begin(), clients.end(),
                                  [](const auto& client) { return !client->client.broken(); });
  if (static_cast<std::size_t>(here) <= most) return;
  for (const auto& client : clients) {  // in the order in which they came
    if (client == clients.back() || client->client.broken() || !silent(*client)) continue;
    // It may have spoken since it was last listened to.
    client->client.serve(POLLIN);
    receive(*client);
    if (client->client.broken()) return;
    if (!silent(*client)) continue;
    return client->client.drop("sent nothing, and other clients need its place");
  }
  clients.back()->client.drop(tooMany);
}

}  // namespace plumbline::simulation
