#include "framework/SelfRegistration.h"

#include <gtest/gtest.h>

#include <string_view>

namespace plumbline {
namespace {

struct Entry {
  const char* name;
  int order;
};

void add(std::vector<Entry>& entries, const Entry& entry) {
  registerInOrder(entries, entry, "engines",
                  [](const Entry& of) { return std::tuple(of.order, std::string_view(of.name)); });
}

TEST(SelfRegistration, entriesAreByOrderThenByName) {
  std::vector<Entry> entries;
  for (const Entry& entry : {Entry{"late", 2}, Entry{"b", 1}, Entry{"first", 0}, Entry{"a", 1}})
    add(entries, entry);
  std::string names;
  for (const Entry& entry : entries) names += std::string(entry.name) + " ";
  EXPECT_EQ(names, "first a b late ");
}

TEST(SelfRegistrationDeathTest, aSecondOfOneNameEndsTheProgram) {
  std::vector<Entry> entries{{"ode", 0}};
  EXPECT_EXIT(add(entries, {"ode", 5}), testing::ExitedWithCode(2),
              "^two engines with the name ode are linked into this program\n$");
}

}  // namespace
}  // namespace plumbline
