#include "gap/inference/InferenceMemory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gap/diagnosis/FormJson.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

/// JSON has no number that is infinite or none.
json jsonOfNumber(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double numberOf(const json& j) {
  if (!j.is_string()) return j.get<double>();
  const std::string& text = j.get_ref<const std::string&>();
  if (text == "nan") return std::nan("");
  if (text != "inf" && text != "-inf") throw std::invalid_argument("no number");
  return text == "inf" ? HUGE_VAL : -HUGE_VAL;
}

std::size_t countOf(const json& j) {
  if (!j.is_number_unsigned()) throw std::invalid_argument("no count");
  return j.get<std::size_t>();
}

std::vector<double> numbersOf(const json& j) {
  std::vector<double> values;
  for (const json& value : j) values.push_back(numberOf(value));
  return values;
}

json jsonOfNumbers(const std::vector<double>& values) {
  json j = json::array();
  for (const double value : values) j.push_back(jsonOfNumber(value));
  return j;
}

/// Sets with each form of a cause (effect, place, variant) written once: many hold the same ones.
class FormTable {
public:
  FormTable() = default;
  FormTable(const json& forms, const Mechanism& robot) {
    for (const json& form : forms) forms_.push_back(formOf(form, robot));
  }

  json jsonOfCauses(const Explanation& causes) {
    json j = json::array();
    for (const Cause& cause : causes) j.push_back({indexOf(cause), jsonOfNumber(cause.value)});
    return j;
  }

  Explanation causesOf(const json& j) const {
    Explanation causes;
    for (const json& cause : j) {
      causes.push_back(forms_.at(countOf(cause.at(0))));
      causes.back().value = numberOf(cause.at(1));
    }
    return causes;
  }

  json jsonOfSet(const Scored& set) {
    json without = json::array();
    for (const Explanation& causes : set.without) without.push_back(jsonOfCauses(causes));
    return {{"causes", jsonOfCauses(set.causes())},
            {"without", std::move(without)},
            {"gain", jsonOfNumbers(set.gain)},
            {"price", jsonOfNumber(set.price)}};
  }

  Scored setOf(const json& j) const {
    Scored set;
    set.fitted.causes = causesOf(j.at("causes"));
    for (const json& causes : j.at("without")) set.without.push_back(causesOf(causes));
    set.gain = numbersOf(j.at("gain"));
    set.price = numberOf(j.at("price"));
    if (set.gain.size() != set.without.size()) throw std::invalid_argument("a set of fewer groups");
    for (const Explanation& causes : set.without)
      if (causes.size() != set.causes().size()) throw std::invalid_argument("a group of fewer causes");
    return set;
  }

  json jsonOfForms() const {
    json forms = json::array();
    for (const Cause& cause : forms_) forms.push_back(jsonOfForm(cause));
    return forms;
  }

private:
  std::size_t indexOf(const Cause& cause) {
    std::size_t i = 0;
    while (i < forms_.size() && !(forms_[i].sameForm(cause) && forms_[i].inactiveIn == cause.inactiveIn)) ++i;
    if (i == forms_.size()) forms_.push_back(cause);
    return i;
  }

  std::vector<Cause> forms_;
};

json jsonOf(const StoredSearch& search) {
  FormTable forms;
  json sets = json::array(), lessOne = json::array();
  for (const Scored& set : search.found.sets) sets.push_back(forms.jsonOfSet(set));
  for (const Scored& set : search.found.lessOne) lessOne.push_back(forms.jsonOfSet(set));
  return {{"forms", forms.jsonOfForms()},
          {"sets", std::move(sets)},
          {"less_one", std::move(lessOne)},
          {"kinds", search.found.kinds},
          {"replays", search.replays}};
}

StoredSearch searchOf(const json& j, const Mechanism& robot) {
  const FormTable forms(j.at("forms"), robot);
  StoredSearch search;
  for (const json& set : j.at("sets")) search.found.sets.push_back(forms.setOf(set));
  for (const json& set : j.at("less_one")) search.found.lessOne.push_back(forms.setOf(set));
  search.found.kinds = countOf(j.at("kinds"));
  search.replays = countOf(j.at("replays"));
  const std::vector<Scored>& sets = search.found.sets;
  if (sets.empty() || search.found.lessOne.size() != sets.front().causes().size())
    throw std::invalid_argument("a search without an answer");
  const auto sameGroups = [&](const Scored& set) { return set.gain.size() == sets.front().gain.size(); };
  if (!std::ranges::all_of(sets, sameGroups) || !std::ranges::all_of(search.found.lessOne, sameGroups))
    throw std::invalid_argument("sets of different groups");
  return search;
}

json jsonOf(const StoredValues& values) {
  FormTable forms;
  json causes = forms.jsonOfCauses(values.causes);
  return {{"forms", forms.jsonOfForms()}, {"causes", std::move(causes)}, {"replays", values.replays}};
}

StoredValues valuesOf(const json& j, const Mechanism& robot) {
  return {FormTable(j.at("forms"), robot).causesOf(j.at("causes")), countOf(j.at("replays"))};
}

std::string counted(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace

InferenceMemory::InferenceMemory(std::string path, std::string mark, const Mechanism& robot,
                                 MemoryFile::Warn warn)
    : file_(std::move(path), std::move(mark), std::move(warn)) {
  if (file_.read([&](const json& content) { take(content, robot); })) {
    stored_ = searches_.size() + values_.size();
  } else {
    searches_.clear();
    values_.clear();
  }
}

void InferenceMemory::take(const json& content, const Mechanism& robot) {
  for (const auto& [name, stored] : content.at("searches").items())
    searches_.emplace(name, searchOf(stored, robot));
  for (const auto& [name, stored] : content.at("values").items())
    values_.emplace(name, valuesOf(stored, robot));
}

const StoredSearch* InferenceMemory::search(const std::string& name, std::size_t groups) const {
  const auto at = searches_.find(name);
  return at != searches_.end() && at->second.found.sets.front().gain.size() == groups ? &at->second : nullptr;
}

const StoredValues* InferenceMemory::values(const std::string& name) const {
  const auto at = values_.find(name);
  return at != values_.end() ? &at->second : nullptr;
}

void InferenceMemory::keep(const std::string& name, StoredSearch search) {
  searches_.insert_or_assign(name, std::move(search));
  write();
}

void InferenceMemory::keep(const std::string& name, StoredValues values) {
  values_.insert_or_assign(name, std::move(values));
  write();
}

void InferenceMemory::write() {
  json content = {{"searches", json::object()}, {"values", json::object()}};
  for (const auto& [name, search] : searches_) content["searches"][name] = jsonOf(search);
  for (const auto& [name, values] : values_) content["values"][name] = jsonOf(values);
  if (file_.write(content)) stored_ = searches_.size() + values_.size();
}

std::string InferenceMemory::sizeText() const {
  std::string text = counted(searches_.size(), "search", "searches");
  if (!values_.empty()) text += " and " + counted(values_.size(), "fit", "fits");
  return text + " done";
}

void InferenceMemory::forget() {
  file_.forget();
  searches_.clear();
  values_.clear();
  stored_ = 0;
}

}  // namespace plumbline::gap
