#include "framework/TestModules.h"

#include <mutex>
#include <stdexcept>

namespace plumbline {

std::vector<std::string>& calls() {
  static std::vector<std::string> list;
  return list;
}

void addCall(const std::string& call) {
  static std::mutex mutex;
  std::lock_guard lock(mutex);
  calls().push_back(call);
}

Controller makeController(const std::string& modulesConfig) {
  calls().clear();
  return Controller({"modules.cfg", {"tests/data/no_config"}}, modulesConfig);
}

void AlphaSource::init() { addCall("AlphaSource:init"); }
void AlphaSource::execute() {
  addCall("AlphaSource:execute");
  cycle_++;
}
void AlphaSource::update(Alpha* theAlpha) {
  addCall("AlphaSource:updateAlpha");
  theAlpha->value = cycle_;
}
MAKE_MODULE(AlphaSource)

void BetaFromAlpha::execute() { addCall("BetaFromAlpha:execute"); }
void BetaFromAlpha::update(Beta* theBeta) {
  addCall("BetaFromAlpha:updateBeta");
  theBeta->value = 10 * theAlpha->value;
}
MAKE_MODULE(BetaFromAlpha);

void GammaFromBeta::execute() { addCall("GammaFromBeta:execute"); }
void GammaFromBeta::update(Gamma* theGamma) {
  addCall("GammaFromBeta:updateGamma");
  theGamma->value = theBeta->value + 1;
}
MAKE_MODULE(GammaFromBeta)

void AlphaFromGamma::update(Alpha* theAlpha) { theAlpha->value = theGamma->value; }
MAKE_MODULE(AlphaFromGamma)

void AlphaFromLastGamma::execute() { addCall("AlphaFromLastGamma:execute"); }
void AlphaFromLastGamma::update(Alpha* theAlpha) { theAlpha->value = theGamma ? theGamma->value + 1 : -1; }
MAKE_MODULE(AlphaFromLastGamma)

void TwinSource::execute() { addCall("TwinSource:execute"); }
void TwinSource::update(Alpha*) { addCall("TwinSource:updateAlpha"); }
void TwinSource::update(Beta*) { addCall("TwinSource:updateBeta"); }
MAKE_MODULE(TwinSource)

void SelfLoop::update(Beta* theBeta) { theBeta->value++; }
MAKE_MODULE(SelfLoop)

void OptionalReader::execute() {
  addCall(std::string("OptionalReader:execute") + (theAlpha ? " Alpha" : "") + (theBeta ? " Beta" : ""));
}
MAKE_MODULE(OptionalReader)

MAKE_MODULE(OrphanReader)

void Stopper::execute() {
  addCall("Stopper:execute");
  if (++cycle_ == 3) requestStop(3, "three cycles are enough");
}
MAKE_MODULE(Stopper)

void Thrower::execute() {
  if (++cycle_ == 2) throw std::runtime_error("thrown on purpose");
}

}  // namespace plumbline

// Outside the namespace it works as well.
MAKE_MODULE(Thrower)
