#pragma once
#include <random>
#include <string>
#include <vector>

namespace plumbline::fuzz {

/// Damages inputs, the same way for the same seed: for a run of the tests that needs no fuzzer.
class Mutator {
public:
  explicit Mutator(std::vector<std::string> seeds, unsigned seed) : seeds_(std::move(seeds)), random_(seed) {}
  std::string next();

private:
  std::size_t below(std::size_t n) { return n ? random_() % n : 0; }
  void damage(std::string& text);

  std::vector<std::string> seeds_;
  std::mt19937 random_;
};

}  // namespace plumbline::fuzz
