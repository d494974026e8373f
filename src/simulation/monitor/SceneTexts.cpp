#include "simulation/monitor/SceneTexts.h"

#include "simspark/LeagueRobots.h"

namespace plumbline::simulation {

using simspark::TeamSide;

namespace {

const std::string unturned = "1 0 0 0 0 1 0 0 0 0 1 0";
const std::string goalMeshTurn =
    "-4.37114e-08 1 4.37114e-08 0 0 -4.37114e-08 1 0 1 4.37114e-08 1.91069e-15 0";
const std::string fieldMeshTurn =
    "-1 -8.74228e-08 -3.82137e-15 0 0 -4.37114e-08 1 0 -8.74228e-08 1 4.37114e-08 -0";

std::string transform(const std::string& turn, const std::string& position,
                      const std::string& children = "") {
  return "(nd TRF (SLT " + turn + ' ' + position + " 1)" + children + ')';
}

std::string mesh(const std::string& file, const std::string& scale, const std::string& materials,
                 const std::string& transparent = "") {
  return "(nd StaticMesh (setVisible 1)" + transparent + " (load models/" + file + ") (sSc " + scale +
         ")(resetMaterials " + materials + "))";
}

std::string light(const std::string& ambient) {
  return "(nd Light (setDiffuse 1 1 1 1) (setAmbient " + ambient + " 1) (setSpecular 0.1 0.1 0.1 1))";
}

std::string goal(const std::string& turn, const std::string& x, const std::string& file,
                 const std::string& colour) {
  std::string parts = transform(goalMeshTurn, "0.3 0 -0.4",
                                mesh(file, "2.18 0.88 0.68", "naogoalnet " + colour, " (setTransparent)"));
  for (const char* bar : {"0 -1.07 0", "0 1.07 0", "-0.28 0 0", "0 0 0.42", "0.3 1.05 0.4", "0.3 -1.05 0.4"})
    parts += transform(unturned, bar);
  return transform(turn, x + " 0 0.4", parts);
}

std::string wall(const std::string& position, const std::string& size) {
  return transform(unturned, position,
                   "(nd SMN (setVisible 1) (load StdUnitBox) (sSc " + size + ") (sMat matGrey))");
}

constexpr int numLines = 21;

std::string makeFieldScene() {
  std::string skies;
  for (int i = 1; i <= 6; ++i)
    skies += (i > 1 ? " " : "") + ("Material_skyrender_000" + std::to_string(i)) + ".tif";
  std::string scene =
      transform(unturned, "-10 10 10", light("0.8 0.8 0.8")) +
      transform(unturned, "10 -10 10", light("0 0 0")) +
      transform(fieldMeshTurn, "0 0 0", mesh("naosoccerfield.obj", "2.5 1 2.5", "None_rcs-naofield.png")) +
      transform(fieldMeshTurn, "0 0 0", mesh("skybox.obj", "10 10 10", skies)) +
      goal(unturned, "-15.3", "leftsoccergoal.obj", "yellow") +
      goal("-1 -8.74228e-08 -0 -0 8.74228e-08 -1 0 0 0 0 1 0", "15.3", "rightsoccergoal.obj", "sky-blue") +
      wall("-24.99 0 0", "1 51 1") + wall("24.99 0 0", "1 51 1") + wall("0 25 0", "50.98 1 1") +
      wall("0 -25 0", "50.98 1 1");
  for (const char* flag : {"-15 10 0", "-15 -10 0", "15 10 0", "15 -10 0"})
    scene += transform(unturned, flag);
  for (int i = 0; i < numLines; ++i) scene += transform(unturned, "0 0 0");
  return scene;
}

std::string makeFieldDifference() {
  std::string scene = "(nd(nd))(nd(nd))(nd(nd StaticMesh))(nd(nd StaticMesh))";
  for (int i = 0; i < 2; ++i) scene += "(nd(nd(nd StaticMesh))(nd)(nd)(nd)(nd)(nd)(nd))";
  for (int i = 0; i < 4; ++i) scene += "(nd(nd SMN))";
  for (int i = 0; i < 4 + numLines; ++i) scene += "(nd)";
  return scene;
}

BodyLook sphere(const std::string& link, const std::string& colour) {
  return {.link = link, .shape = "StdUnitSphere", .scale = "0.01 0.01 0.01", .material = colour};
}

BodyLook meshLook(const std::string& link, const std::string& file, const std::string& scale,
                  const std::string& materials) {
  return {.link = link, .mesh = file + ".obj", .scale = scale, .materials = materials};
}

}  // namespace

const std::string& fieldScene() {
  static const std::string text = makeFieldScene();
  return text;
}

const std::string& fieldDifference() {
  static const std::string text = makeFieldDifference();
  return text;
}

std::vector<BodyLook> robotLooks(int type) {
  const std::string digit = std::to_string(type);
  const bool toes = simsparkRobot(type).has(lToePitch);
  const std::string typed = toes ? "team naowhite" : "team type naowhite";
  std::vector<BodyLook> looks;
  looks.push_back(meshLook("torso", "naobody" + digit, "0.1 0.1 0.1", "num " + typed));
  looks.back().turned = looks.back().marker = true;
  looks.push_back(
      {.link = "neck", .shape = "StdCapsule 0.015 0.08", .scale = "1 1 1", .material = "matDarkGrey"});
  looks.push_back(meshLook("head", "naohead", "0.1 0.1 0.1", "team naoblack naogrey naowhite"));
  looks.back().turned = true;
  for (const std::string side : {"r", "l"}) {
    looks.push_back(sphere(side + "Shoulder", "matYellow"));
    looks.push_back(meshLook(side + "UpperArm", side + "upperarm" + digit, "0.07 0.07 0.07", typed));
    looks.push_back(sphere(side + "Elbow", "matYellow"));
    looks.push_back(meshLook(side + "LowerArm", side + "lowerarm", "0.05 0.05 0.05", "team naowhite"));
  }
  for (const std::string side : {"r", "l"}) {
    looks.push_back(sphere(side + "Hip1", "matYellow"));
    looks.push_back(sphere(side + "Hip2", "matYellow"));
    looks.push_back(meshLook(side + "Thigh", side + "thigh", "0.07 0.07 0.07",
                             side == "r" ? "num team naowhite" : "team naowhite"));
    looks.push_back(meshLook(side + "Shank", side + "shank" + digit, "0.08 0.08 0.08", typed));
    looks.push_back(sphere(side + "Ankle", "matRed"));
    looks.push_back(meshLook(side + "Foot", side + "foot", toes ? "0.08 0.062241 0.08" : "0.08 0.08 0.08",
                             "team naowhite"));
    if (toes) looks.push_back(meshLook(side + "Toe", side + "foot", "0.08 0.0228259 0.04", "team naowhite"));
  }
  return looks;
}

std::string materialNames(std::string_view materials, int type, int unum, TeamSide side) {
  std::string names;
  for (std::size_t begin = 0; begin < materials.size();) {
    std::size_t end = materials.find(' ', begin);
    if (end == std::string_view::npos) end = materials.size();
    const std::string_view word = materials.substr(begin, end - begin);
    if (begin > 0) names += ' ';
    if (word == "num")
      names += side == TeamSide::none ? "matNum" : "matNum" + std::to_string(unum);
    else if (word == "team")
      names += side == TeamSide::left ? "matLeft" : side == TeamSide::right ? "matRight" : "matTeam";
    else if (word == "type")
      names += "matType" + std::to_string(type);
    else
      names += word;
    begin = end + 1;
  }
  return names;
}

}  // namespace plumbline::simulation
