#include "Page.h"
#include "gap/blind/CaseText.h"
#include "gap/blind/ScoreJudge.h"

namespace plumbline::bench {

using namespace gap;

std::string casesSection(const BenchResult& r) {
  const BlindJudge judge(r.robot);
  std::string misses, all;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < r.set.cases.size(); ++i) {
    const BlindCase& c = r.set.cases[i];
    const BlindAnswer& a = r.answers[i];
    const bool right = judge.right(c, a);
    wrong += !right;
    if (!right) misses += row({c.name, nameOf(c.kind), hidden(c), number(c.ratio), said(a, true)});
    all += row({c.name, nameOf(c.kind), hidden(c), number(c.ratio), said(a, false), right ? "yes" : "no"});
  }
  return "\n## What went wrong\n\n" + std::to_string(wrong) + " of " + std::to_string(r.set.cases.size()) +
         " cases, weak ones included. A mixture is right with both effects and no third.\n\n" +
         (wrong ? head({"case", "kind", "hidden", "gap over noise", "said instead"}) + misses : "") +
         "\n## Every case\n\n" + head({"case", "kind", "hidden", "gap over noise", "answer", "right"}) + all;
}

}  // namespace plumbline::bench
