#include "gap/diagnosis/FormJson.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

nlohmann::json jsonOfForm(const Cause& cause) {
  return {cause.effect->id, cause.place.at, std::string(cause.place.axis ? 1 : 0, cause.place.axis),
          cause.variant, cause.inactiveIn};
}

Cause formOf(const nlohmann::json& form, const Mechanism& robot) {
  const Effect* effect = findEffect(form.at(0).get<std::string>());
  if (!effect) throw std::invalid_argument("an effect that the library lacks");
  const nlohmann::json& variant = form.at(3);
  if (!variant.is_number_unsigned() ||
      variant.get<std::uint64_t>() >= static_cast<std::uint64_t>(effect->numVariants()))
    throw std::invalid_argument("a variant that the effect lacks");
  return {effect, findPlace(*effect, robot, form.at(1).get<std::string>(), form.at(2).get<std::string>()), 0,
          variant.get<int>(), form.at(4).get<std::vector<std::string>>()};
}

}  // namespace plumbline::gap
