// S-expressions, and what the agents of a team say to each other.
#include <cmath>

#include "fuzz/Readers.h"
#include "modules/communication/code/BeliefCode.h"
#include "modules/communication/code/SayAlphabet.h"
#include "simspark/SExpression.h"

namespace plumbline::fuzz {
namespace {

void visitTree(const simspark::SExpressions::Node& node, std::size_t depth, std::size_t& nodes) {
  require(depth <= 64, "a tree deeper than its limit");
  ++nodes;
  if (!node.isList()) return;
  require(!node.at(0) || node.at(0).isList() || node.name() == node.at(0).text(), "a list of another name");
  for (auto child = node.first(); child; child = child.next()) visitTree(child, depth + 1, nodes);
}

void sExpression(std::string_view bytes) {
  simspark::SExpressions::Limits limits;
  limits.nodes = 5000;
  simspark::SExpressions trees(limits);
  const bool good = trees.parse(bytes);
  require(good == trees.error().empty(), "an error that is none");
  require(trees.errorPosition() <= bytes.size(), "an error beyond the end");
  std::size_t nodes = 0;
  for (auto tree = trees.first(); tree; tree = tree.next()) visitTree(tree, 0, nodes);
  require(nodes <= limits.nodes, "more nodes than are taken");
}

void teamMessage(std::string_view bytes) {
  for (const std::int64_t slot : {std::int64_t{0}, std::int64_t{7}, std::int64_t{1} << 50}) {
    const auto belief = decodeBelief(bytes, "Team", slot);
    if (!belief) continue;
    require(encodeBelief(*belief, "Team", slot) == bytes, "a belief changes when it is said again");
  }
  const auto bits = SayBits::fromText(bytes);
  if (bits) require(bits->text() == bytes, "letters change when they are read back");
}

std::vector<std::string> sExpressionSeeds() {
  return {"(a (b 1 2)(c))(d)",
          "((((((()))))))",
          "(nd (SLT 1 0 0 1)(nd StaticMesh))",
          std::string(80, '('),
          "a b",
          "()"};
}
std::vector<std::string> teamMessageSeeds() {
  TeamBelief belief;
  std::vector<std::string> all;
  for (const std::int64_t slot : {0, 7}) all.push_back(encodeBelief(belief, "Team", slot));
  all.push_back("ABCDEFGHIJKLMNOPQRST");
  return all;
}

const Registered sExpressionTarget({"sExpression", sExpression, sExpressionSeeds, 30000});
const Registered teamMessageTarget({"teamMessage", teamMessage, teamMessageSeeds, 20000});

}  // namespace
}  // namespace plumbline::fuzz
