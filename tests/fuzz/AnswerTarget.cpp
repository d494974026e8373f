// Answers of bin/gap diagnose, as gap report, next, apply and blind score read them.
#include <nlohmann/json.hpp>

#include "fuzz/Readers.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "gap/report/ReportPage.h"
#include "robot/MechanismFile.h"

namespace plumbline::fuzz {
namespace {

void gapAnswer(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFile("answer.json", bytes);
  refusesInOneLine([&] {
    const nlohmann::json answer = gap::readAnswer(path);
    const std::string page = gap::reportPage("<script>/*ANSWER*/</script>", answer, robot);
    require(page.find('<', 8) == page.rfind('<'), "an answer that ends the page's script");
  });
  refusesInOneLine([&] { gap::settingsOf(gap::readAnswer(path), path); });
  refusesInOneLine([&] { gap::causesOf(gap::readAnswer(path), path, robot); });
}

std::vector<std::string> gapAnswerSeeds() {
  return {
      R"({"verdict": "effect", "robot": "xl330_pendulum", "effects": [{"effect": "backlash", "at": "pendulum", "value": 0.03,
 "interval": [0.02, 0.04], "probability": 0.9, "rivals": [{"effect": "coulomb_friction", "at": "pendulum", "value": 0.1, "probability": 0.1}]}],
 "gap": {"before": 2.5, "after": 1.1}})",
      R"({"verdict": "none", "effects": []})",
      R"({"verdict": "unknown", "effects": [{"effect": "link_mass", "at": "arm", "axis": "", "value": 1.1}]})"};
}

const Registered gapAnswerTarget({"gapAnswer", gapAnswer, gapAnswerSeeds, 2000});

}  // namespace
}  // namespace plumbline::fuzz
