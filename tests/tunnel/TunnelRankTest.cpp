// Whole ranks in threads, with a queue in place of MPI.
#include "tunnel/TunnelRank.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <deque>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

#include "support/FarOff.h"
#include "support/Processes.h"
#include "support/Thrown.h"
#include "tunnel/ServerRank.h"
#include "tunnel/TestSockets.h"
#include "tunnel/WorkerRank.h"

namespace plumbline::tunnel {
namespace {

/// What is on its way to each rank.
struct Post {
  std::mutex mutex;
  std::map<int, std::deque<std::pair<int, std::string>>> to;
};

class PostTransport final : public RankTransport {
public:
  PostTransport(Post& post, int rank, int ranks) : post_(post), rank_(rank), ranks_(ranks) {}
  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  void send(int to, std::string message) override {
    const std::lock_guard lock(post_.mutex);
    post_.to[to].emplace_back(rank_, std::move(message));
  }
  bool receive(int& from, std::string& message) override {
    const std::lock_guard lock(post_.mutex);
    auto& queue = post_.to[rank_];
    if (queue.empty()) return false;
    std::tie(from, message) = std::move(queue.front());
    queue.pop_front();
    return true;
  }
  bool sentAll() const override { return true; }

private:
  Post& post_;
  int rank_, ranks_;
};

/// What is sent leaves only after its rank has looked for messages three times more.
class SlowTransport final : public RankTransport {
public:
  explicit SlowTransport(RankTransport& fast) : fast_(fast) {}
  int rank() const override { return fast_.rank(); }
  int ranks() const override { return fast_.ranks(); }
  void send(int to, std::string message) override {
    waiting_.emplace_back(to, std::move(message));
    looks_ = 0;
  }
  bool receive(int& from, std::string& message) override {
    if (++looks_ >= 3)
      for (; !waiting_.empty(); waiting_.pop_front())
        fast_.send(waiting_.front().first, std::move(waiting_.front().second));
    return fast_.receive(from, message);
  }
  bool sentAll() const override { return waiting_.empty(); }

private:
  RankTransport& fast_;
  std::deque<std::pair<int, std::string>> waiting_;
  int looks_ = 0;
};

/// One rank in a thread of its own. What it ends with is its status, "early" and a status, or what it throws.
class RankThread {
public:
  RankThread(Post& post, int rank, int ranks, const TunnelOptions& options)
      : transport_(post, rank, ranks), end_(std::async(std::launch::async, [this, options] {
          std::string end;
          const std::string thrown = thrownBy([&] {
            std::unique_ptr<TunnelRank> own;
            if (transport_.rank() == 0)
              own = std::make_unique<ServerRank>(transport_, options);
            else
              own = std::make_unique<WorkerRank>(transport_, options);
            const RankEnd how = own->run(stop);
            end = (how.early ? "early " : "") + std::to_string(how.status);
          });
          return end.empty() ? thrown : end;
        })) {}
  bool endsWithin(double seconds) {
    return end_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
  }
  std::string end() {
    if (!endsWithin(farOff)) {
      ADD_FAILURE() << "rank " << transport_.rank() << " does not end";
      stop.request(0, "the test is over");
    }
    return end_.get();
  }
  StopSignal stop;

private:
  PostTransport transport_;
  std::future<std::string> end_;
};

std::vector<std::string> shell(const std::string& text) { return {"sh", "-c", text}; }

struct TunnelRankTest : testing::Test {
  TunnelRankTest() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    options.port = server.port;
    options.server =
        shell("until [ -e " + folder + "/end ]; do sleep 0.01; done; exit $(cat " + folder + "/end)");
    options.worker = shell("echo $$ {port} > " + folder + "/new{rank}; mv " + folder + "/new{rank} " +
                           folder + "/worker{rank}; sleep 3600");
  }
  void endServer(int status) const { std::ofstream(folder + "/end") << status; }
  /// The process and the port of a worker's command.
  std::pair<pid_t, int> worker(int rank) const {
    std::pair<pid_t, int> both;
    comesTrue([&] {
      std::ifstream file(folder + "/worker" + std::to_string(rank));
      return static_cast<bool>(file >> both.first >> both.second);
    });
    return both;
  }
  bool comes(TestSocket& socket, const std::string& text) {
    return comesTrue([&] {
      socket.receive();
      return socket.received == text;
    });
  }
  TestSocket accepted() {
    std::optional<TestSocket> socket;
    if (!comesTrue([&] { return (socket = server.accept()).has_value(); }))
      throw std::runtime_error("nobody connected");
    return std::move(*socket);
  }

  const std::string folder = testing::TempDir() + "tunnel_rank";
  TestServer server;
  TunnelOptions options{.server = {}, .worker = {}, .grace = 0.2, .silence = 5};
  Post post;
};

TEST_F(TunnelRankTest, connectionsOfAllWorkersGoToTheServerAndItsStatusEndsAll) {
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options), two(post, 2, 3, options);
  const auto [first, firstPort] = worker(1);
  const auto [second, secondPort] = worker(2);
  EXPECT_NE(firstPort, secondPort);
  EXPECT_NE(firstPort, server.port);
  TestSocket a = TestSocket::connected(firstPort), atA = accepted();
  TestSocket b = TestSocket::connected(secondPort), atB = accepted();
  a.send("from a");
  b.send("from b");
  EXPECT_TRUE(comes(atA, "from a"));
  EXPECT_TRUE(comes(atB, "from b"));
  atA.send("last words");
  endServer(0);
  EXPECT_TRUE(comes(a, "last words"));
  EXPECT_EQ(zero.end(), "0");
  EXPECT_EQ(one.end(), "0");
  EXPECT_EQ(two.end(), "0");
  EXPECT_TRUE(processEnded(first) && processEnded(second));
}

TEST_F(TunnelRankTest, aServerThatFailsEndsAllWithItsStatusAtOnce) {
  options.grace = 60;
  RankThread zero(post, 0, 2, options), one(post, 1, 2, options);
  const pid_t pid = worker(1).first;
  endServer(3);
  EXPECT_EQ(zero.end(), "3");
  EXPECT_EQ(one.end(), "0");
  EXPECT_TRUE(processEnded(pid));
}

TEST_F(TunnelRankTest, aWorkerMayEndByItselfOnceTheServerHas) {
  options.grace = 60;
  options.worker = shell("echo $$ {port} > " + folder + "/worker1; until [ -e " + folder +
                         "/end ]; do sleep 0.01; done; " + "sleep 0.3; touch " + folder + "/done");
  RankThread zero(post, 0, 2, options), one(post, 1, 2, options);
  worker(1);
  endServer(0);
  EXPECT_EQ(zero.end(), "0");
  EXPECT_EQ(one.end(), "0");
  EXPECT_TRUE(std::filesystem::exists(folder + "/done"));
}

TEST_F(TunnelRankTest, aRankWhoseWorkerHasEndedStaysUntilAllHave) {
  // MPI's own farewell is one of all ranks: who says it alone waits there, and mpirun takes its patience's
  // end for a crash.
  options.grace = 60;
  options.worker = shell("echo $$ {port} > " + folder + "/worker{rank}; [ {rank} = 1 ] || until [ -e " +
                         folder + "/let ]; do sleep 0.01; done");
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options), two(post, 2, 3, options);
  worker(1);
  worker(2);
  endServer(0);
  EXPECT_FALSE(one.endsWithin(0.7));
  std::ofstream(folder + "/let") << "";
  EXPECT_EQ(zero.end(), "0");
  EXPECT_EQ(one.end(), "0");
  EXPECT_EQ(two.end(), "0");
}

TEST_F(TunnelRankTest, anyRankThatIsStoppedStopsAll) {
  for (const int which : {0, 2}) {
    std::filesystem::remove(folder + "/worker1");
    std::filesystem::remove(folder + "/worker2");
    std::map<int, std::unique_ptr<RankThread>> ranks;
    for (int rank = 0; rank < 3; ++rank) ranks[rank] = std::make_unique<RankThread>(post, rank, 3, options);
    const pid_t first = worker(1).first, second = worker(2).first;
    ranks[which]->stop.request(0, "stop");
    for (auto& [rank, thread] : ranks) EXPECT_EQ(thread->end(), "early 130") << rank;
    EXPECT_TRUE(processEnded(first) && processEnded(second));
    post.to.clear();
  }
}

TEST_F(TunnelRankTest, whoIsContinuedWithoutHavingBeenStoppedEnds) {
  RankThread zero(post, 0, 2, options), one(post, 1, 2, options);
  const pid_t pid = worker(1).first;
  // On a busy machine a rank may seem to have been stopped; mpirun then sends SIGTERM a second later.
  for (int i = 0; i < 100 && !zero.endsWithin(0.05); ++i) raise(SIGCONT);
  EXPECT_EQ(zero.end(), "early 130");
  EXPECT_EQ(one.end(), "early 130");
  EXPECT_TRUE(processEnded(pid));
}

TEST_F(TunnelRankTest, whoWasStoppedGoesOnWhenContinued) {
  const pid_t process = fork();
  if (process == 0) {
    // A process of its own, which can be stopped; its status tells how its rank ended.
    options.server = {"sleep", "100"};
    PostTransport transport(post, 0, 2);
    StopSignal never;
    ServerRank rank(transport, options);
    _exit(rank.run(never).early ? 99 : 98);
  }
  usleep(200000);
  kill(process, SIGSTOP);
  usleep(200000);
  kill(process, SIGCONT);
  usleep(100000);
  EXPECT_FALSE(processEnded(process));
  int status = 0;  // and from here on it runs
  for (int i = 0; i < 100 && !processEnds(process, 0.05); ++i) kill(process, SIGCONT);
  waitpid(process, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 99);
}

TEST_F(TunnelRankTest, aRankThatHasGoneEndsTheOthers) {
  options.silence = 1;
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options);
  const pid_t pid = worker(1).first;
  PostTransport(post, 2, 3).send(0, encodeFrame({FrameKind::alive}));  // and never again
  EXPECT_EQ(zero.end(), "rank 2 has gone: nothing came from it for 1 s");
  EXPECT_EQ(one.end(), "early 2");
  EXPECT_TRUE(processEnded(pid));
}

TEST_F(TunnelRankTest, nonsenseFromARankEndsAll) {
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options);
  worker(1);
  PostTransport(post, 2, 3).send(0, "nonsense");
  EXPECT_EQ(zero.end(), "rank 2 sent frame: 8 bytes are no header");
  EXPECT_EQ(one.end(), "early 2");
}

TEST_F(TunnelRankTest, framesThatAreNotOnesToSendEndAll) {
  for (const auto& [frame, why] :
       {std::pair{Frame{FrameKind::over}, "rank 2 sent a frame that is not a worker's to send"},
        std::pair{Frame{FrameKind::bye}, "rank 2 sent a frame that is not a worker's to send"},
        std::pair{Frame{FrameKind::credit, 5, 1},
                  "rank 2 sent a frame of connection 5, which nobody opened"}}) {
    post.to.clear();
    RankThread zero(post, 0, 3, options);
    PostTransport(post, 2, 3).send(0, encodeFrame(frame));
    EXPECT_EQ(zero.end(), why);
  }
}

TEST_F(TunnelRankTest, aCommandThatCannotBeStartedEndsAll) {
  TunnelOptions wrong = options;
  wrong.worker = {"no-such-command"};
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options), two(post, 2, 3, wrong);
  EXPECT_EQ(two.end(), "cannot start no-such-command: No such file or directory");
  EXPECT_EQ(zero.end(), "early 2");
  EXPECT_EQ(one.end(), "early 2");
}

TEST_F(TunnelRankTest, oneWorkerMayFailButNotAll) {
  options.worker = shell("echo $$ {port} > " + folder + "/worker{rank}; until [ -e " + folder +
                         "/fail{rank} ]; do sleep 0.01; done; exit 4");
  RankThread zero(post, 0, 3, options), one(post, 1, 3, options), two(post, 2, 3, options);
  worker(1);
  worker(2);
  std::ofstream(folder + "/fail1") << "";
  usleep(300000);
  TestSocket still = TestSocket::connected(worker(2).second), atServer = accepted();
  still.send("goes on");
  EXPECT_TRUE(comes(atServer, "goes on"));
  std::ofstream(folder + "/fail2") << "";
  EXPECT_EQ(zero.end(), "the commands of all workers have failed, the last one with status 4");
  EXPECT_EQ(one.end(), "early 2");
  EXPECT_EQ(two.end(), "early 2");
}

TEST_F(TunnelRankTest, aWorkerThatFailsIsStartedAgainWhereThatIsWanted) {
  options.again = true;
  options.worker =
      shell("echo x >> " + folder + "/starts; [ $(wc -l < " + folder + "/starts) -gt 1 ] || exit 1; echo " +
            "$$ {port} > " + folder + "/worker1; sleep 3600");
  RankThread zero(post, 0, 2, options), one(post, 1, 2, options);
  const pid_t pid = worker(1).first;
  EXPECT_GT(pid, 0);
  endServer(0);
  EXPECT_EQ(zero.end(), "0");
  EXPECT_EQ(one.end(), "0");
  EXPECT_TRUE(processEnded(pid));
}

TEST_F(TunnelRankTest, whoEndsEarlySeesItsLastWordOff) {
  PostTransport fast(post, 0, 2);
  SlowTransport slow(fast);
  ServerRank zero(slow, options);
  StopSignal stop;
  stop.request(0, "the test is over");
  EXPECT_TRUE(zero.run(stop).early);
  ASSERT_FALSE(post.to[1].empty());
  EXPECT_EQ(decodeFrame(post.to[1].back().second).kind, FrameKind::stop);
}

}  // namespace
}  // namespace plumbline::tunnel
