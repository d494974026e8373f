#pragma once
#include <string>

#include "optimization/farm/LineSocket.h"
#include "optimization/farm/Messages.h"
#include "optimization/farm/ParameterSource.h"

namespace plumbline::farm {

struct FarmAddress {
  static constexpr int standardPort = 3400;
  std::string host = "127.0.0.1";
  int port = standardPort;
  std::string token{};
};

/// The optimiser behind a server's port. Throws std::runtime_error, one line, for a server that cannot be
/// reached, goes away, refuses this client or sends nonsense.
class FarmClient final : public ParameterSource {
public:
  /// Connects, says its name and waits for the server's welcome. Throws std::runtime_error, also when
  /// `stopDescriptor` becomes readable, which ends every wait; -1: nothing does.
  FarmClient(const FarmAddress& server, const std::string& name, int stopDescriptor = -1);

  const Welcome& welcome() const { return welcome_; }
  std::optional<Trial> next(double seconds) override;
  void tell(const Trial& trial, std::span<const double> costs,
            const std::map<std::string, double>& figures) override;
  bool isOver() const override { return !over_.empty(); }
  /// Becomes readable when something has come: for who waits for more than this.
  int descriptor() const { return socket_.descriptor(); }

private:
  bool take();

  std::string place_;
  int stopDescriptor_;
  LineSocket socket_;
  Welcome welcome_;
  std::optional<Trial> trial_{};
  std::string over_;
};

/// What a server says of its search, as JSON in one line. Errors as above.
std::string readStatus(const FarmAddress& server);

}  // namespace plumbline::farm
