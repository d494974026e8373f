#include "gap/blind/CaseText.h"

#include <cstdio>

#include "gap/blind/ScoreJudge.h"

namespace plumbline::gap {

namespace {

void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

std::string number(const char* format, double x) {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

}  // namespace

std::string nameOfOne(const std::string& effect, const std::string& at, const std::string& axis,
                      double value) {
  return effect + " at " + (at == "*" ? "all joints" : at) + (axis.empty() ? "" : " " + axis) + " " +
         number("%.3g", value);
}

std::string hidden(const BlindCase& c) {
  std::string text;
  for (const BlindEffect& e : c.effects) add(text, nameOfOne(e.effect, e.at, e.axis, e.value));
  return text.empty() ? "nothing" : text;
}

std::string said(const BlindAnswer& a, bool withRivals) {
  if (a.verdict.empty()) return "no answer";
  std::string text;
  for (const BlindAnswer::Named& e : a.effects) {
    add(text, nameOfOne(e.effect, e.at, e.axis, e.value) + " (" + number("%.3f", e.probability));
    if (withRivals)
      for (const NamedCause& rival : e.rivals)
        text += "; or " + rival.effect + " at " + rival.at + (rival.axis.empty() ? "" : " " + rival.axis) +
                " " + number("%.3f", rival.probability);
    text += ")";
  }
  if (a.verdict == "effect") return text;
  return text.empty() || !withRivals ? a.verdict : a.verdict + ", nearest " + text;
}

std::string caseList(const BlindSet& set, const std::vector<BlindAnswer>& answers, const Mechanism& robot,
                     bool all) {
  const BlindJudge judge(robot);
  std::string text;
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const BlindCase& c = set.cases[i];
    const bool right = judge.right(c, answers[i]);
    if (right && !all) continue;
    text += "case " + c.name + ", " + nameOf(c.kind) + ": " + (right ? "right" : "wrong") +
            "\n  hidden: " + hidden(c);
    if (c.kind != BlindKind::none)
      text += "; " + number("%.1f", c.ratio) + " times the noise in " + c.ratioChannel;
    text += "\n  said:   " + said(answers[i], true) + "\n";
  }
  return text;
}

}  // namespace plumbline::gap
