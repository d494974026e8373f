// How many causes of a gap the diagnosis knows, and whether backlash is one.
#include <cstdio>

#include "gap/effects/Effects.h"

int main() {
  std::printf("%s, backlash %s\n", plumbline::gap::effects().size() > 20 ? "many" : "few",
              plumbline::gap::findEffect("backlash") ? "known" : "unknown");
}
