#include "simspark/FieldScene.h"

#include <algorithm>
#include <charconv>

#include "simspark/MeshNames.h"

namespace plumbline::simspark {

using Eigen::Matrix4d;

namespace {

constexpr std::string_view nodeBegin = "(nd", transformBegin = "(SLT ";

/// Just behind the first list of a text; npos if it is not closed.
std::size_t endOfList(std::string_view text) {
  int depth = 0;
  for (std::size_t i = text.find_first_of("()"); i != std::string_view::npos;
       i = text.find_first_of("()", i + 1)) {
    depth += text[i] == '(' ? 1 : -1;
    if (depth <= 0) return i + 1;
  }
  return std::string_view::npos;
}

/// The matrix of a node whose name ends at `at`, if it has one.
bool readTransform(std::string_view text, std::size_t at, Matrix4d& matrix) {
  while (at < text.size() && text[at] != '(' && text[at] != ')') ++at;  // "TRF"
  if (text.substr(at, transformBegin.size()) != transformBegin) return false;
  const char* next = text.data() + at + transformBegin.size();
  const char* const end = text.data() + text.size();
  Matrix4d read;
  for (int i = 0; i < 16; ++i) {
    while (next < end && *next == ' ') ++next;
    const auto [stop, error] = std::from_chars(next, end, read(i % 4, i / 4));
    if (error != std::errc()) return false;
    next = stop;
  }
  matrix = read;
  return true;
}

}  // namespace

FieldScene::Chain FieldScene::chainOf(const std::vector<int>& nodes) {
  Chain chain;
  for (const int node : nodes) {
    const auto found =
        std::find_if(transforms_.begin(), transforms_.end(), [&](const auto& t) { return t.node == node; });
    chain.push_back(static_cast<std::size_t>(found - transforms_.begin()));
    if (found == transforms_.end()) transforms_.push_back({node});
  }
  return chain;
}

/// Finds the transforms that are used, in a whole scene that SceneState has read without an error.
void FieldScene::index(std::string_view message) {
  struct Open {
    bool node, transform;
    int number;
  };
  std::vector<Open> open;
  std::vector<std::vector<int>> robotNodes;
  std::vector<int> ballNodes;
  numNodes_ = 0;
  // The transforms around here; the innermost of a body's mesh only turns the mesh.
  const auto around = [&open](bool withoutLast) {
    std::vector<int> nodes;
    for (const Open& list : open)
      if (list.transform) nodes.push_back(list.number);
    if (withoutLast && !nodes.empty()) nodes.pop_back();
    return nodes;
  };
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (message[i] == ')' && !open.empty()) open.pop_back();
    if (message[i] != '(') continue;
    const bool node = message.substr(i, nodeBegin.size()) == nodeBegin;
    open.push_back({node, message.substr(i, 7) == "(nd TRF", node ? numNodes_++ : 0});
    constexpr std::string_view load = "(load ";
    if (message.substr(i, load.size()) != load) continue;
    const std::string_view mesh = message.substr(i + load.size());
    if (mesh.starts_with(bodyMesh)) robotNodes.push_back(around(true));
    if (mesh.starts_with(ballMesh)) ballNodes = around(false);
  }
  transforms_.clear();
  robots_.clear();
  for (const auto& nodes : robotNodes) robots_.push_back(chainOf(nodes));
  ball_ = chainOf(ballNodes);
  // In the order of the text; the chains follow.
  std::vector<std::size_t> order(transforms_.size()), place(transforms_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [this](auto a, auto b) { return transforms_[a].node < transforms_[b].node; });
  std::vector<Transform> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.push_back(transforms_[order[i]]);
  }
  transforms_ = std::move(sorted);
  for (Chain& chain : robots_)
    for (std::size_t& i : chain) i = place[i];
  for (std::size_t& i : ball_) i = place[i];
}

std::string FieldScene::readDifference(std::string_view rest) {
  int node = 0;
  auto next = transforms_.begin();
  for (std::size_t i = rest.find(nodeBegin); i != std::string_view::npos;
       i = rest.find(nodeBegin, i + nodeBegin.size())) {
    if (next != transforms_.end() && next->node == node) {
      readTransform(rest, i + nodeBegin.size(), next->matrix);
      ++next;
    }
    ++node;
  }
  return node == numNodes_ ? "" : "a difference to another scene";
}

std::string FieldScene::update(std::string_view message) {
  const std::size_t end = endOfList(message);
  if (end == std::string_view::npos) return "no list of game state";
  const std::string_view rest = message.substr(end);
  constexpr std::string_view difference = "(RDS";
  if (rest.substr(0, difference.size()) == difference) {
    if (!complete()) return "a difference before a whole scene";
    if (std::string why = scene_.update(message.substr(0, end)); !why.empty()) return why;
    return readDifference(rest);
  }
  std::string why = scene_.update(message);
  if (!why.empty() || rest.empty() || !complete()) return why;
  index(rest);
  return readDifference(rest);
}

Matrix4d FieldScene::compose(const Chain& chain) const {
  Matrix4d product = Matrix4d::Identity();
  for (const std::size_t i : chain) product = product * transforms_[i].matrix;
  return product;
}

FieldState FieldScene::state() const {
  SceneState now;  // what fieldState() needs of it, with where everything is now
  const Scoreboard& board = scene_;
  static_cast<Scoreboard&>(now) = board;
  now.ball = compose(ball_).block<3, 1>(0, 3);
  now.robots.resize(std::min(scene_.robots.size(), robots_.size()));
  for (std::size_t i = 0; i < now.robots.size(); ++i) {
    now.robots[i].side = scene_.robots[i].side;
    now.robots[i].unum = scene_.robots[i].unum;
    now.robots[i].T_world_torso = sceneRobotPose(compose(robots_[i]));
  }
  return fieldState(now);
}

}  // namespace plumbline::simspark
