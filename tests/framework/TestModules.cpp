#include "framework/TestModules.h"

#include <stdexcept>

namespace plumbline {

std::vector<std::string>& calls() {
  static std::vector<std::string> list;
  return list;
}

Controller makeController(const std::string& modulesConfig) {
  calls().clear();
  return Controller({"modules.cfg", {"tests/data/no_config"}}, modulesConfig);
}

void AlphaSource::init() { calls().push_back("AlphaSource:init"); }
void AlphaSource::execute() {
  calls().push_back("AlphaSource:execute");
  cycle_++;
}
void AlphaSource::update(Alpha* theAlpha) {
  calls().push_back("AlphaSource:updateAlpha");
  theAlpha->value = cycle_;
}
MAKE_MODULE(AlphaSource)

void BetaFromAlpha::execute() { calls().push_back("BetaFromAlpha:execute"); }
void BetaFromAlpha::update(Beta* theBeta) {
  calls().push_back("BetaFromAlpha:updateBeta");
  theBeta->value = 10 * theAlpha->value;
}
MAKE_MODULE(BetaFromAlpha);

void GammaFromBeta::execute() { calls().push_back("GammaFromBeta:execute"); }
void GammaFromBeta::update(Gamma* theGamma) {
  calls().push_back("GammaFromBeta:updateGamma");
  theGamma->value = theBeta->value + 1;
}
MAKE_MODULE(GammaFromBeta)

void AlphaFromGamma::update(Alpha* theAlpha) { theAlpha->value = theGamma->value; }
MAKE_MODULE(AlphaFromGamma)

void AlphaFromLastGamma::execute() { calls().push_back("AlphaFromLastGamma:execute"); }
void AlphaFromLastGamma::update(Alpha* theAlpha) { theAlpha->value = theGamma ? theGamma->value + 1 : -1; }
MAKE_MODULE(AlphaFromLastGamma)

void TwinSource::execute() { calls().push_back("TwinSource:execute"); }
void TwinSource::update(Alpha*) { calls().push_back("TwinSource:updateAlpha"); }
void TwinSource::update(Beta*) { calls().push_back("TwinSource:updateBeta"); }
MAKE_MODULE(TwinSource)

void SelfLoop::update(Beta* theBeta) { theBeta->value++; }
MAKE_MODULE(SelfLoop)

void OptionalReader::execute() {
  calls().push_back(std::string("OptionalReader:execute") + (theAlpha ? " Alpha" : "") +
                    (theBeta ? " Beta" : ""));
}
MAKE_MODULE(OptionalReader)

MAKE_MODULE(OrphanReader)

void Stopper::execute() {
  calls().push_back("Stopper:execute");
  if (++cycle_ == 3) requestStop(3, "three cycles are enough");
}
MAKE_MODULE(Stopper)

void Thrower::execute() {
  if (++cycle_ == 2) throw std::runtime_error("thrown on purpose");
}

}  // namespace plumbline

// Outside the namespace it works as well.
MAKE_MODULE(Thrower)
