#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

std::vector<const LeagueEffect*>& registeredEffects() {
  static std::vector<const LeagueEffect*> all;
  return all;
}

void demandOf(const LeagueEffect& effect, bool fits, const char* what) {
  if (fits) return;
  std::fprintf(stderr, "the league's effect \"%.*s\" %s\n", static_cast<int>(effect.id.size()),
               effect.id.data(), what);
  std::exit(2);
}

}  // namespace

LeagueEffectLoader::LeagueEffectLoader(const LeagueEffect& effect) {
  demandOf(effect, !effect.id.empty() && effect.lower < effect.upper,
           "needs an id and a range: lower must be less than upper");
  demandOf(effect, effect.body || effect.torque || effect.command || effect.sensor || effect.ground,
           "changes nothing");
  demandOf(effect, findLeagueEffect(effect.id) == nullptr, "exists twice in this program");
  const auto place = [](const LeagueEffect* e) { return std::tuple(e->order, e->id); };
  std::vector<const LeagueEffect*>& all = registeredEffects();
  all.insert(std::ranges::upper_bound(all, place(&effect), {}, place), &effect);
}

const std::vector<const LeagueEffect*>& leagueEffects() { return registeredEffects(); }

const LeagueEffect* findLeagueEffect(std::string_view id) {
  const auto& all = registeredEffects();
  const auto found = std::ranges::find(all, id, &LeagueEffect::id);
  return found == all.end() ? nullptr : *found;
}

std::vector<EffectInUse> effectsInUse(const std::vector<EffectSetting>& settings) {
  std::vector<EffectInUse> used;
  for (const LeagueEffect* effect : leagueEffects()) {
    EffectSettings own;
    std::ranges::copy_if(settings, std::back_inserter(own),
                         [&](const EffectSetting& setting) { return setting.effect == effect->id; });
    if (!own.empty()) used.push_back({effect, std::move(own)});
  }
  std::ranges::stable_sort(used, {}, [](const EffectInUse& use) { return use.effect->turn; });
  return used;
}

}  // namespace plumbline::simulation
