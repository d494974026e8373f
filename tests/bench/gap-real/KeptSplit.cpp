#include "KeptSplit.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/WriteFile.h"
#include "support/Today.h"

namespace plumbline::bench {

using nlohmann::json;

namespace {

std::string text(const char* format, double a) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, a);
  return buffer;
}

void writeFindings(std::ostream& page, const RealResult& r) {
  page << "\n| cause | value | interval | probability | closes alone | closes last | or |\n"
          "|---|---|---|---|---|---|---|\n";
  for (const gap::Finding& f : r.diagnosis.findings) {
    std::string rivals;
    for (const gap::Rival& rival : f.rivals)
      rivals += (rivals.empty() ? "" : ", ") + describe(rival.cause) + text(" (%.2f)", rival.probability);
    const std::string inactiveIn = gap::describeInactiveIn(f.cause);
    page << "| " << f.cause.effect->id << " at " << f.cause.place.at << (inactiveIn.empty() ? "" : ", ")
         << inactiveIn << " | " << text("%.3g", f.cause.value) << " " << f.cause.effect->unit << " | "
         << text("%.3g", f.lower) << " to " << text("%.3g", f.upper) << " | " << text("%.2f", f.probability)
         << " | " << text("%.0f %%", 100 * f.closedAlone) << " | " << text("%.0f %%", 100 * f.closedLast)
         << " | " << rivals << " |\n";
  }
}

/// Mean over the tests that count of the share closed, without a floor: what a claim is about.
double meanClosed(const RealSplit& split, const RealResult& r) {
  double sum = 0, n = 0;
  for (const TestError& e : r.tests) {
    if (!split.repeats.empty() && !e.repeated) continue;
    sum += 1 - e.after / e.before;
    ++n;
  }
  return sum / n;
}

std::string pageOf(const RealSplit& split, const RealResult& r, Method method) {
  std::ostringstream page;
  page << "\n### " << split.name << " by " << nameOf(method) << ": " << split.what << "\n\nVerdict "
       << nameOf(r.diagnosis.verdict)
       << "; position, root mean square over the tests: " << text("%.1f", 1000 * r.before) << " mrad before, "
       << text("%.1f", 1000 * r.after) << " after, floor "
       << (r.floor > 0 ? text("%.1f", 1000 * r.floor) : "none known (no repeats)") << ": **"
       << text("%.0f %%", 100 * r.closed()) << " closed**. The diagnosis took " << text("%.0f", r.seconds)
       << " s of the processor.";
  if (r.claim)
    page << " It claims " << text("%.0f", 100 * r.claim->closed) << " % ("
         << text("%.0f", 100 * r.claim->lower) << " to " << text("%.0f", 100 * r.claim->upper)
         << ") of a recording that it has not seen; the tests' mean is "
         << text("%.0f %%", 100 * meanClosed(split, r)) << ".";
  page << "\n";
  writeFindings(page, r);
  page << "\n| test | before, mrad | after, mrad | floor, mrad | closed |\n|---|---|---|---|---|\n";
  for (const TestError& e : r.tests)
    page << "| " << e.run << (split.repeats.empty() || e.repeated ? "" : " (does not count)") << " | "
         << text("%.1f", 1000 * e.before) << " | " << text("%.1f", 1000 * e.after) << " | "
         << (e.repeated ? text("%.1f", 1000 * e.floor) : "") << " | "
         << text("%.0f %%", 100 * (e.before - e.after) / (e.before - e.floor)) << " |\n";
  return page.str();
}

}  // namespace

KeptSplit::KeptSplit(const std::string& folder, const std::string& robot, const std::string& split,
                     Method method)
    : id_(robot + "." + split + "." + nameOf(method)), method_(method), file_(folder + "/" + id_ + ".json") {}

bool KeptSplit::done() const { return std::filesystem::exists(file_); }

json KeptSplit::read() const {
  std::ifstream stream(file_);
  json piece = json::parse(stream, nullptr, false);
  if (!piece.is_object() || !piece.contains("page") || !piece.contains("figures") || !piece.contains("mean"))
    throw std::runtime_error(file_ + " is not what a split leaves; remove it and run again");
  return piece;
}

void KeptSplit::write(const RealSplit& split, const RealResult& r) const {
  const json figures = {
      {{"name", "gap-real.closed." + id_},
       {"value", r.closed()},
       {"unit", "1"},
       {"better", "higher"},
       {"target", 0.7}},
      {{"name", "gap-real.time." + id_}, {"value", r.seconds}, {"unit", "s"}, {"better", "lower"}}};
  json kept{{"page", pageOf(split, r, method_)},
            {"figures", figures},
            {"closed", r.closed()},
            {"mean", meanClosed(split, r)},
            {"seconds", r.seconds},
            {"date", today()},
            {"claimed", nullptr}};
  if (r.claim) kept["claimed"] = r.claim->closed;
  writeFile(file_, kept.dump(1) + "\n");
  std::printf("%s: %.1f -> %.1f mrad, floor %.1f, closed %.0f %%, %s, %.0f s\n", id_.c_str(), 1000 * r.before,
              1000 * r.after, 1000 * r.floor, 100 * r.closed(), nameOf(r.diagnosis.verdict), r.seconds);
  for (const gap::Finding& f : r.diagnosis.findings)
    std::printf("  %s %.2f\n", describe(f.cause).c_str(), f.probability);
  std::fflush(stdout);
}

}  // namespace plumbline::bench
