// How fast a linear inverted pendulum of 0.3 m that starts over its left foot at 0.1 m/s is after 0.1 s.
#include <cstdio>

#include "walking/model/LinearInvertedPendulum.h"

int main() {
  using namespace plumbline::walking;
  WalkState state;
  state.velocity.x() = 0.1;
  std::printf("%.4f m/s\n", LinearInvertedPendulum(0.3).move(state, {}, 0.1).velocity.x());
}
