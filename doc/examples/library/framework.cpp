// What was meant by a name that is wrong by a letter.
#include <iostream>

#include "framework/NearestName.h"

int main() {
  std::cout << plumbline::nearestName("BallModle", {"BallModel", "RobotPose"}) << '\n';
}
