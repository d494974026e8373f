#pragma once
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumbline {

/// For what registers itself before main: ends the program with status 2, because two of a kind ("modules")
/// have the same name.
[[noreturn]] inline void endLinkedTwice(const char* kind, const std::string& name) {
  std::fprintf(stderr, "two %s with the name %s are linked into this program\n", kind, name.c_str());
  std::exit(2);
}

/// Takes an entry into a list of what registers itself, behind those of the same place. `placeOf` gives an
/// entry's order and name (std::string_view) as a tuple; a second entry of one name ends the program as
/// endLinkedTwice() does.
template <typename Entry, typename PlaceOf>
void registerInOrder(std::vector<Entry>& entries, std::type_identity_t<Entry> entry, const char* kind,
                     PlaceOf placeOf) {
  const auto place = placeOf(entry);
  const auto nameOf = [&](const Entry& of) { return std::get<1>(placeOf(of)); };
  if (std::ranges::count(entries, std::get<1>(place), nameOf) > 0)
    endLinkedTwice(kind, std::string(std::get<1>(place)));
  const auto next = std::ranges::upper_bound(entries, place, {}, placeOf);
  entries.insert(next, std::move(entry));
}

}  // namespace plumbline
