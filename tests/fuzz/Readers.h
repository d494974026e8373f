#pragma once
#include <array>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/Targets.h"

namespace plumbline::fuzz {

/// Stands between the parts of an input that goes into more than one file.
constexpr std::string_view separator = "\n---8<---\n";

/// What is before the separator and what is behind it.
std::array<std::string_view, 2> halves(std::string_view bytes);

/// A folder in memory that goes with the process; one for all targets.
std::string scratchFolder();
/// Writes a file there; for readers that take paths. Returns its path.
std::string scratchFile(const std::string& name, std::string_view bytes);

/// The text of a file of the tree, for seeds.
std::string contentOf(const std::string& path);
/// Of each file with this extension in a folder of the tree, in the order of their names.
std::vector<std::string> contentsOf(const std::string& folder, const std::string& extension);

/// True under libFuzzer, which learns what inputs are compared with: it would write a library's words into an
/// input that the error then quotes.
extern bool learns;

/// What a person reads: one line, from this project's own words.
void expectOneLine(const std::string& what);

/// Has a reader read: it may refuse by an exception, but one that says in a line what is wrong.
template <typename Read>
void refusesInOneLine(Read&& read) {
  try {
    read();
  } catch (const Broken&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Broken("more memory is wanted than there is");
  } catch (const std::invalid_argument& error) {
    expectOneLine(error.what());
  } catch (const std::logic_error&) {
    throw Broken("an error of the program, not of the input");
  } catch (const std::exception& error) {
    expectOneLine(error.what());
  }
}

}  // namespace plumbline::fuzz
