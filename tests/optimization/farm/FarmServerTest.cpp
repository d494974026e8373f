#include "optimization/farm/FarmServer.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <list>
#include <thread>

#include "../Functions.h"
#include "optimization/Cmaes.h"
#include "optimization/farm/FarmClient.h"
#include "support/FarOff.h"

namespace plumbline::farm {
namespace {

using Eigen::VectorXd;

Search serverSearch(std::int64_t generations = 20) {
  CmaesOptions options;
  options.population = 8;
  options.ahead = 3;
  options.stop.maxGenerations = generations;
  options.stop.tolFun = options.stop.tolX = 0;
  return {std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(4, 1), 0.5), options),
          Averaging{1, 2}, 3};
}

/// Works with any source: the one in the process and the one behind TCP alike.
void evaluate(ParameterSource& source) {
  while (!source.isOver()) {
    const auto trial = source.next(0.2);
    if (!trial) continue;
    source.tell(*trial, std::vector<double>(trial->seeds.size(), sphere(trial->parameters)), {{"figure", 2}});
  }
}

/// A server that serves on a thread until its search is over.
struct Running {
  explicit Running(Search& search_, FarmOptions options = {}, Journal* journal = nullptr)
      : server(search_, journal, {"sphere", {{"dimension", "4"}}, 4}, options),
        thread([this] { over = server.serve(stop); }) {}
  ~Running() {
    const std::uint64_t one = 1;
    EXPECT_EQ(write(stop, &one, sizeof one), static_cast<ssize_t>(sizeof one));
    thread.join();
    close(stop);
  }
  FarmAddress address(const std::string& token = "") const { return {"127.0.0.1", server.port(), token}; }

  int stop = eventfd(0, EFD_CLOEXEC);
  std::atomic<bool> over = false;
  FarmServer server;
  std::thread thread;
};

template <typename F>
std::string errorOf(F&& f) {
  try {
    f();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(FarmServer, givesTheSameAsTheOptimiserInTheProcess) {
  Search inProcess = serverSearch(), farmed = serverSearch();
  LocalSource local(inProcess);
  evaluate(local);
  {
    Running running(farmed);
    std::vector<std::thread> workers;
    for (int i = 0; i < 6; ++i)
      workers.emplace_back([&] {
        FarmClient client(running.address(), "thread");
        EXPECT_EQ(client.welcome().task, "sphere");
        EXPECT_EQ(client.welcome().options.at("dimension"), "4");
        evaluate(client);
      });
    for (std::thread& worker : workers) worker.join();
  }
  EXPECT_TRUE(farmed.optimizer().save() == inProcess.optimizer().save());
}

TEST(FarmServer, saysWhetherTheSearchIsOverOrItWasStopped) {
  Search whole = serverSearch(2), stopped = serverSearch(2);
  const auto serve = [](Search& search, bool evaluated) {
    const int stop = eventfd(0, EFD_CLOEXEC);
    FarmServer server(search, nullptr, {"sphere", {}, 4}, {});
    std::thread worker([&] {
      if (evaluated) {
        FarmClient client({"127.0.0.1", server.port(), ""}, "one");
        evaluate(client);
      } else {
        eventfd_write(stop, 1);
      }
    });
    const bool over = server.serve(stop);
    worker.join();
    close(stop);
    return over;
  };
  EXPECT_TRUE(serve(whole, true));
  EXPECT_FALSE(serve(stopped, false));
}

TEST(FarmServer, workersThatDieAreReplacedAndNothingIsLost) {
  Search inProcess = serverSearch(), farmed = serverSearch();
  LocalSource local(inProcess);
  evaluate(local);
  {
    Running running(farmed, {"127.0.0.1", 0, "", {60, 1000}});
    for (int i = 0; i < 100; ++i) {  // takes a trial and goes
      FarmClient client(running.address(), "dies");
      client.next(1);
    }
    FarmClient client(running.address(), "stays");
    evaluate(client);
  }
  EXPECT_TRUE(farmed.optimizer().save() == inProcess.optimizer().save());
}

TEST(FarmServer, aBadClientIsDroppedAlone) {
  Search farmed = serverSearch();
  Running running(farmed);
  FarmClient good(running.address(), "good");
  const auto answerTo = [&](const std::string& line) {
    LineSocket bad(connectTo("127.0.0.1", running.server.port()), maxLine, maxLine);
    bad.send(line);
    std::string answer;
    while (!bad.next(answer) && !bad.broken()) bad.wait(1);
    return answer;
  };
  EXPECT_EQ(answerTo("GET / HTTP/1.1"), R"({"error":"hello: broken JSON"})");
  EXPECT_EQ(answerTo(R"({"hello": "worker"})"), R"({"error":"hello: a key is missing or of another type"})");
  EXPECT_EQ(answerTo(R"({"hello": "boss", "version": 1})"), R"({"error":"hello: must be worker or status"})");
  EXPECT_EQ(answerTo(R"({"hello": "worker", "version": 9})"),
            R"({"error":"hello: the server speaks version 1"})");
  EXPECT_EQ(errorOf([&] {
              FarmClient liar(running.address(), "liar");
              const Trial trial = *liar.next(2);
              liar.tell(trial, std::vector<double>(7, 0.0), {});
              liar.next(2);
            }),
            "the optimisation server at 127.0.0.1:" + std::to_string(running.server.port()) +
                ": answer: 7 costs for trial 2; answer the trial that was sent, with one cost for each run");
  evaluate(good);
  EXPECT_TRUE(good.isOver());
}

TEST(FarmServer, wantsTheTokenThatItWasGiven) {
  Search farmed = serverSearch(2);
  EXPECT_EQ(errorOf([&] {
              FarmServer(farmed, nullptr, {"sphere", {}, 4}, {"0.0.0.0", 0, "", {}});
            }),
            "port 0.0.0.0:0 is open to others: that needs a token");
  Running running(farmed, {"127.0.0.1", 0, "secret", {}});
  EXPECT_EQ(errorOf([&] { FarmClient client(running.address("wrong"), "one"); }),
            "the optimisation server at 127.0.0.1:" + std::to_string(running.server.port()) +
                ": the token is wrong or missing");
  FarmClient client(running.address("secret"), "one");
  evaluate(client);
}

TEST(FarmServer, silentConnectionsGiveWay) {
  Search farmed = serverSearch(2);
  // No silence is too long, so one that comes late gets in only if another gives way, however busy the
  // machine is.
  Running running(farmed, {"127.0.0.1", 0, "", {}, 50, 1e9});
  FarmClient early(running.address(), "early");
  std::list<LineSocket> silent;
  for (int i = 0; i < 100; ++i)
    silent.emplace_back(connectTo("127.0.0.1", running.server.port()), maxLine, maxLine);
  silent.back().send("{\"hello\": \"work");
  FarmClient(running.address(), "late");
  std::string line;
  while (!silent.front().next(line) && !silent.front().broken()) silent.front().wait(farOff);
  EXPECT_EQ(line, R"({"error":"you have said nothing, and others need the place"})");
  evaluate(early);
}

TEST(FarmServer, whoComesWhenAllWorkIsSentAway) {
  Search farmed = serverSearch(2);
  Running running(farmed, {"127.0.0.1", 0, "", {}, 3});
  std::list<FarmClient> workers;
  for (int i = 0; i < 3; ++i) workers.emplace_back(running.address(), "works");
  EXPECT_EQ(errorOf([&] { FarmClient client(running.address(), "late"); }),
            "the optimisation server at 127.0.0.1:" + std::to_string(running.server.port()) +
                ": too many clients: 3 are there");
}

TEST(FarmServer, isNotWaitedForOnceAClientIsStopped) {
  int port = 0;
  const int silent = listenOn("127.0.0.1", 0, port), stop = eventfd(0, EFD_CLOEXEC);
  const std::string place = "127.0.0.1:" + std::to_string(port);
  std::thread stops([&] {
    pollfd came{silent, POLLIN, 0};
    poll(&came, 1, -1);
    const int client = accept(silent, nullptr, nullptr);
    char hello = 0;
    while (recv(client, &hello, 1, 0) != 1) {
    }
    eventfd_write(stop, 1);
  });
  EXPECT_EQ(errorOf([&] {
              FarmClient client({"127.0.0.1", port, ""}, "one", stop);
            }),
            "the optimisation server at " + place + " had said nothing before the stop");
  stops.join();
  EXPECT_EQ(errorOf([&] {
              FarmClient client({"127.0.0.1", port, ""}, "two", stop);
            }),
            "cannot reach " + place + ": Operation canceled");
  LineSocket client(connectTo("127.0.0.1", port), maxLine, maxLine);
  EXPECT_FALSE(client.wait(3600, stop));
  close(stop);
  close(silent);
}

TEST(FarmServer, tellsItsStatus) {
  Search farmed = serverSearch(2);
  Running running(farmed);
  const std::string status = readStatus(running.address());
  EXPECT_NE(status.find(R"("generation":0)"), std::string::npos) << status;
  EXPECT_NE(status.find(R"("task":"sphere")"), std::string::npos) << status;
}

}  // namespace
}  // namespace plumbline::farm
