#include "KeptSplit.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/WriteFile.h"

namespace plumbline::bench {

using nlohmann::json;

namespace {

std::string text(const char* format, double a) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, a);
  return buffer;
}

void tellFindings(std::ostream& page, const RealResult& r) {
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

std::string pageOf(const RealSplit& split, const RealResult& r) {
  std::ostringstream page;
  page << "\n### " << split.name << ": " << split.what << "\n\nVerdict " << nameOf(r.diagnosis.verdict)
       << "; position, root mean square over the tests: " << text("%.1f", 1000 * r.before) << " mrad before, "
       << text("%.1f", 1000 * r.after) << " after, floor "
       << (r.floor > 0 ? text("%.1f", 1000 * r.floor) : "none known (no repeats)") << ": **"
       << text("%.0f %%", 100 * r.closed()) << " closed**. The diagnosis took " << text("%.0f", r.seconds)
       << " s.\n";
  tellFindings(page, r);
  page << "\n| test | before, mrad | after, mrad | floor, mrad | closed |\n|---|---|---|---|---|\n";
  for (const TestError& e : r.tests)
    page << "| " << e.run << (split.repeats.empty() || e.repeated ? "" : " (does not count)") << " | "
         << text("%.1f", 1000 * e.before) << " | " << text("%.1f", 1000 * e.after) << " | "
         << (e.repeated ? text("%.1f", 1000 * e.floor) : "") << " | "
         << text("%.0f %%", 100 * (e.before - e.after) / (e.before - e.floor)) << " |\n";
  return page.str();
}

}  // namespace

KeptSplit::KeptSplit(const std::string& folder, const std::string& robot, const std::string& split)
    : id_(robot + "." + split), file_(folder + "/" + id_ + ".json") {}

bool KeptSplit::done() const { return std::filesystem::exists(file_); }

json KeptSplit::read() const {
  std::ifstream stream(file_);
  json piece = json::parse(stream, nullptr, false);
  if (!piece.is_object() || !piece.contains("page") || !piece.contains("figures"))
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
  writeFile(file_, json{{"page", pageOf(split, r)}, {"figures", figures}}.dump(1) + "\n");
  std::printf("%s: %.1f -> %.1f mrad, floor %.1f, closed %.0f %%, %s, %.0f s\n", id_.c_str(), 1000 * r.before,
              1000 * r.after, 1000 * r.floor, 100 * r.closed(), nameOf(r.diagnosis.verdict), r.seconds);
  for (const gap::Finding& f : r.diagnosis.findings)
    std::printf("  %s %.2f\n", describe(f.cause).c_str(), f.probability);
  std::fflush(stdout);
}

}  // namespace plumbline::bench
