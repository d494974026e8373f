// What a coach edits: the rules, the formation, set pieces and situations.
#include "framework/ConfigFile.h"
#include "fuzz/Readers.h"
#include "modules/behavior/formation/FormationTable.h"
#include "modules/behavior/setpiece/SetPieces.h"
#include "simulation/referee/RulesFile.h"
#include "situation/SituationFile.h"
#include "situation/SituationKinds.h"
#include "situation/SituationPicture.h"

namespace plumbline::fuzz {
namespace {

void rulesFile(std::string_view bytes) {
  const std::string path = scratchFile("rules.yaml", bytes);
  refusesInOneLine([&] { simulation::readRules(path); });
}

void formationFile(std::string_view bytes) {
  const std::string path = scratchFile("formation.yaml", bytes);
  refusesInOneLine([&] {
    const ConfigFile file(path);
    const FormationTable table(file.root());
    for (int place = 0; place < table.size(); ++place)
      for (const Vec2& ball : {Vec2(0, 0), Vec2(-20, -20), Vec2(15, 10), Vec2(3.3, -4.4)})
        require(table.at(place, ball).allFinite(), "a place that is nowhere");
  });
}

void setPieceFile(std::string_view bytes) {
  const std::string path = scratchFile("cornerOwn.yaml", bytes);
  refusesInOneLine([&] {
    const SetPiece piece = readSetPiece("cornerOwn", ConfigFile(path).root());
    std::vector<SetPiecePlace> stand;
    if (piece.stand) stand.push_back(*piece.stand);
    for (const auto& places : {piece.kick, stand, piece.places})
      for (const SetPiecePlace& place : places)
        for (const Vec2& ball : {Vec2(0, 0), Vec2(-15, 0), Vec2(15, -10)})
          for (const bool onRight : {false, true})
            require(place.at(ball, 15, onRight).allFinite(), "a place that is nowhere");
  });
}

/// What is read is drawn, and written so that it reads back.
void situationFile(std::string_view bytes) {
  const std::string path = scratchFile("situation.yaml", bytes);
  refusesInOneLine([&] {
    const Situation situation = readSituation(path);
    const std::string picture = situationPicture(situation, "situation", FieldSize());
    require(picture.find("nan") == std::string::npos || situation.about.find("nan") != std::string::npos,
            "drawn nowhere");
    require(picture.size() < 60000, "a picture without an end");
    const std::string text = situationText(situation);
    require(situationText(readSituation(scratchFile("written.yaml", text))) == text,
            "written, it reads otherwise");
  });
}

std::vector<std::string> rulesFileSeeds() {
  return {contentOf("doc/reference/rules.yaml"), "halfTime: 300\n"};
}
std::vector<std::string> formationFileSeeds() { return {contentOf("config/formation.yaml")}; }

std::vector<std::string> setPieceFileSeeds() {
  return {contentOf("config/set_pieces/cornerOwn.yaml"), contentOf("config/set_pieces/kickInOwn.yaml"),
          contentOf("config/set_pieces/restartOpponent.yaml")};
}

std::vector<std::string> situationFileSeeds() {
  std::vector<std::string> seeds;
  for (const std::string& kind : situationKindNames())
    for (std::string& text : contentsOf("tests/data/situations/" + kind, ".yaml"))
      seeds.push_back(std::move(text));
  return seeds;
}

const Registered rulesFileTarget({"rulesFile", rulesFile, rulesFileSeeds, 1200});
const Registered formationFileTarget({"formationFile", formationFile, formationFileSeeds, 800});
const Registered setPieceFileTarget({"setPieceFile", setPieceFile, setPieceFileSeeds, 800});
const Registered situationFileTarget({"situationFile", situationFile, situationFileSeeds, 600});

}  // namespace
}  // namespace plumbline::fuzz
