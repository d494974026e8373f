#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace plumbline {

/// The identity of a type, known even where the type is only declared.
template <typename T>
inline constexpr char moduleObjectKey = 0;

/// Objects that every module of an agent can reach, each by its type: the framework does not know them. They
/// are given by main (command line options, ...) or made by a class registered with MAKE_MODULE_OBJECT.
class ModuleObjects {
public:
  template <typename T>
  void set(std::shared_ptr<T> object) {
    setObject(&moduleObjectKey<T>, std::move(object));
  }
  /// The object of that type, made now if only its maker is known; null if there is none.
  template <typename T>
  T* find() {
    return static_cast<T*>(findObject(&moduleObjectKey<T>));
  }

  using Maker = std::shared_ptr<void> (*)();
  /// For MAKE_MODULE_OBJECT.
  static bool addMaker(const void* key, Maker maker);

private:
  void setObject(const void* key, std::shared_ptr<void> object);
  void* findObject(const void* key);

  std::mutex mutex_;
  std::map<const void*, std::shared_ptr<void>> objects_;
};

}  // namespace plumbline

/// In a .cpp: every agent has an object of type Interface, an Implementation made when a module first asks.
#define MAKE_MODULE_OBJECT(Interface, Implementation)                                                        \
  [[maybe_unused]] static const bool plumblineObject##Implementation = ::plumbline::ModuleObjects::addMaker( \
      &::plumbline::moduleObjectKey<Interface>, []() -> std::shared_ptr<void> {                              \
        return std::shared_ptr<Interface>(std::make_shared<Implementation>());                               \
      });
