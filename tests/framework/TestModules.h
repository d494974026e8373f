#pragma once
#include <string>
#include <vector>

#include "framework/Controller.h"
#include "framework/Module.h"

// Small modules the framework's tests put together by modules.cfg. Each call is written down.
namespace plumbline {

/// What was called, in order: `Module:execute`, `Module:updateAlpha`, ...
std::vector<std::string>& calls();
/// Adds a call; from any thread.
void addCall(const std::string& call);

/// A controller for a modules.cfg of this text.
Controller makeController(const std::string& modulesConfig);

REPRESENTATION(Alpha)
class Alpha : public AlphaBase {
public:
  int value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};

REPRESENTATION(Beta)
class Beta : public BetaBase {
public:
  int value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};

REPRESENTATION(Gamma)
class Gamma : public GammaBase {
public:
  int value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};

/// Required by OrphanReader and provided by nobody.
REPRESENTATION(Orphan)
class Orphan : public OrphanBase {
public:
  double value = 0;
};

/// Counts cycles into Alpha.
MODULE(AlphaSource)
  PROVIDES(Alpha)
END_MODULE
class AlphaSource : public AlphaSourceBase {
public:
  void init() override;
  void execute() override;
  void update(Alpha* theAlpha) override;

private:
  int cycle_ = 0;
};

/// Beta = 10 Alpha.
MODULE(BetaFromAlpha)
  REQUIRES(Alpha)
  PROVIDES(Beta)
END_MODULE
class BetaFromAlpha : public BetaFromAlphaBase {
public:
  void execute() override;
  void update(Beta* theBeta) override;
};

/// Gamma = Beta + 1.
MODULE(GammaFromBeta)
  REQUIRES(Beta)
  PROVIDES(Gamma)
END_MODULE
class GammaFromBeta : public GammaFromBetaBase {
public:
  void execute() override;
  void update(Gamma* theGamma) override;
};

/// Can close a cycle with the two before it.
MODULE(AlphaFromGamma)
  REQUIRES(Gamma)
  PROVIDES(Alpha)
END_MODULE
class AlphaFromGamma : public AlphaFromGammaBase {
public:
  void update(Alpha* theAlpha) override;
};

/// Alpha = Gamma of the last cycle + 1: USES makes no cycle.
MODULE(AlphaFromLastGamma)
  USES(Gamma)
  PROVIDES(Alpha)
END_MODULE
class AlphaFromLastGamma : public AlphaFromLastGammaBase {
public:
  void execute() override;
  void update(Alpha* theAlpha) override;
};

/// One module, two representations: one node of the graph.
MODULE(TwinSource)
  PROVIDES(Alpha)
  PROVIDES(Beta)
END_MODULE
class TwinSource : public TwinSourceBase {
public:
  void execute() override;
  void update(Alpha* theAlpha) override;
  void update(Beta* theBeta) override;
};

/// Requires what it provides.
MODULE(SelfLoop)
  REQUIRES(Beta)
  PROVIDES(Beta)
END_MODULE
class SelfLoop : public SelfLoopBase {
public:
  void update(Beta* theBeta) override;
};

/// Writes down which of its inputs are there.
MODULE(OptionalReader)
  REQUIRES_IF_PROVIDED(Alpha)
  USES(Beta)
END_MODULE
class OptionalReader : public OptionalReaderBase {
public:
  void execute() override;
};

MODULE(OrphanReader)
  REQUIRES(Orphan)
END_MODULE
class OrphanReader : public OrphanReaderBase {};

/// Ends the agent in its third cycle with exit code 3.
MODULE(Stopper)
END_MODULE
class Stopper : public StopperBase {
public:
  void execute() override;

private:
  int cycle_ = 0;
};

/// Throws in its second cycle.
MODULE(Thrower)
END_MODULE
class Thrower : public ThrowerBase {
public:
  void execute() override;

private:
  int cycle_ = 0;
};

}  // namespace plumbline
