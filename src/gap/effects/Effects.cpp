#include "gap/effects/Effects.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <tuple>

namespace plumbline::gap {

namespace {

std::vector<const Effect*>& registered() {
  static std::vector<const Effect*> all;
  return all;
}

void demand(bool fits, const Effect& effect, const char* what) {
  if (fits) return;
  std::fprintf(stderr, "effect \"%.*s\" %s\n", static_cast<int>(effect.id.size()), effect.id.data(), what);
  std::exit(2);
}

}  // namespace

EffectLoader::EffectLoader(const Effect& effect) {
  demand(!effect.id.empty() && !effect.unit.empty() && !effect.sites.empty() && !effect.sentence.empty(),
         effect, "needs an id, a unit, sites and a sentence");
  demand(effect.apply != nullptr, effect, "has nothing to apply");
  demand(effect.lower < effect.upper, effect, "has no range: lower must be less than upper");
  demand(!effect.starts.empty() && std::ranges::all_of(effect.starts,
                                                       [&](double start) {
                                                         return start >= effect.lower &&
                                                                start <= effect.upper &&
                                                                start != effect.nominal;
                                                       }),
         effect, "needs starts within lower and upper, other than nominal");
  demand(effect.perJointFit.rank == 0 || sitsAtJoints(effect), effect,
         "needs Site::joint among its sites for a part in the fit of all joints");
  demand(effect.perJointFit.variant >= 0 && effect.perJointFit.variant < effect.numVariants(), effect,
         "has no variant of the number that perJointFit names");
  demand(findEffect(effect.id) == nullptr, effect, "exists twice in this program");
  const auto place = [](const Effect* e) { return std::tuple(e->order, e->id); };
  std::vector<const Effect*>& all = registered();
  all.insert(std::ranges::upper_bound(all, place(&effect), {}, place), &effect);
}

const std::vector<const Effect*>& effects() { return registered(); }

const Effect* findEffect(std::string_view id) {
  for (const Effect* effect : effects())
    if (effect->id == id) return effect;
  return nullptr;
}

std::vector<const Effect*> actuatorEffects() {
  std::vector<const Effect*> list = effects();
  std::erase_if(list, [](const Effect* effect) { return effect->perJointFit.rank == 0; });
  std::ranges::stable_sort(list, {}, [](const Effect* effect) { return effect->perJointFit.rank; });
  return list;
}

bool sitsAtJoints(const Effect& effect) {
  return std::ranges::find(effect.sites, Site::joint) != effect.sites.end();
}

std::vector<Place> placesOf(const Effect& effect, const Mechanism& mechanism) {
  std::vector<Place> bare;
  for (const Site site : effect.sites) {
    switch (site) {
      case Site::joint:
        for (int i = 0; i < mechanism.numJoints(); ++i) {
          const auto& joint = mechanism.joints[static_cast<std::size_t>(i)];
          if (joint.driver < 0) bare.push_back({site, i, joint.name});
        }
        break;
      case Site::link:
        for (std::size_t i = 0; i < mechanism.links.size(); ++i)
          bare.push_back({site, static_cast<int>(i), mechanism.links[i].name});
        break;
      case Site::foot:
        for (std::size_t i = 0; i < mechanism.feet.size(); ++i)
          bare.push_back({site, static_cast<int>(i), mechanism.feet[i].name});
        break;
      case Site::everywhere:
        // All joints of a robot with one motor are that one.
        if (!sitsAtJoints(effect) || mechanism.onlyMotor() < 0) bare.push_back({site, -1, "*"});
        break;
      case Site::imu:
        if (mechanism.hasImu) bare.push_back({site, -1, "imu"});
        break;
      case Site::ground:
        if (!mechanism.feet.empty()) bare.push_back({site, -1, "ground"});
        break;
    }
  }
  if (effect.ofServo && mechanism.sharesServo()) bare.push_back({Site::everywhere, -1, "*"});
  for (std::size_t g = 0; g < mechanism.groups.size() && effect.ofServo; ++g)
    bare.push_back({Site::everywhere, static_cast<int>(g), mechanism.groups[g].name});
  if (!effect.hasAxis) return bare;
  std::vector<Place> places;
  for (const Place& place : bare)
    for (const char axis : {'x', 'y', 'z'}) {
      if (place.site == Site::ground && axis == 'z') continue;
      places.push_back(place);
      places.back().axis = axis;
    }
  return places;
}

Place findPlace(const Effect& effect, const Mechanism& mechanism, std::string_view at,
                std::string_view axis) {
  const bool everywhere = std::ranges::find(effect.sites, Site::everywhere) != effect.sites.end();
  if (const int only = mechanism.onlyMotor(); at == "*" && everywhere && sitsAtJoints(effect) && only >= 0)
    at = mechanism.joints[static_cast<std::size_t>(only)].name;
  const std::vector<Place> places = placesOf(effect, mechanism);
  const char letter = axis.empty() ? '\0' : axis.front();
  std::string known;
  for (const Place& place : places) {
    if (place.at == at && place.axis == letter) return place;
    std::string name = place.at;
    if (place.axis) name += std::string(" axis ") + place.axis;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(std::string(effect.id) + " cannot be at '" + std::string(at) +
                              (axis.empty() ? "'" : "' axis '" + std::string(axis) + "'") +
                              "; possible places: " + known);
}

}  // namespace plumbline::gap
