#include "framework/ModuleObjects.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"
#include "framework/TestModules.h"

namespace plumbline {

/// Made when a module first asks for it.
class Clock {
public:
  virtual ~Clock() = default;
  virtual std::string name() const = 0;
};

struct Greeting {
  std::string text;
};

struct Unknown {};

MODULE(ObjectUser)
END_MODULE
class ObjectUser : public ObjectUserBase {
public:
  void init() override {
    addCall(object<Greeting>().text);
    addCall(object<Clock>().name());
    addCall(findObject<Unknown>() ? "unknown found" : "unknown missing");
  }
};
MAKE_MODULE(ObjectUser)

MODULE(ObjectMisser)
END_MODULE
class ObjectMisser : public ObjectMisserBase {
public:
  void init() override { object<Unknown>(); }
};
MAKE_MODULE(ObjectMisser)

namespace {

class TestClock : public Clock {
public:
  TestClock() { made++; }
  std::string name() const override { return "test clock"; }
  static inline int made = 0;
};
MAKE_MODULE_OBJECT(Clock, TestClock)

TEST(ModuleObjectsTest, modulesReachThemByType) {
  TestClock::made = 0;
  Controller controller = makeController("ObjectUser\nStopper\n");
  EXPECT_EQ(TestClock::made, 0);
  controller.objects().set(std::make_shared<Greeting>(Greeting{"hello"}));
  controller.init();
  EXPECT_EQ(calls(), (std::vector<std::string>{"hello", "test clock", "unknown missing"}));
  EXPECT_EQ(TestClock::made, 1);  // one for all modules
}

TEST(ModuleObjectsTest, aMissingOneIsNamed) {
  Controller controller = makeController("ObjectMisser\n");
  try {
    controller.init();
    FAIL() << "nothing was thrown";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(
        error.what(),
        "module ObjectMisser needs an object of type plumbline::Unknown, which this program does not have");
  }
}

}  // namespace
}  // namespace plumbline
