#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/Range.h"

namespace plumbline {

/// Points to a parameter's value in its owner: one alternative for each type that a parameter can have.
using ParameterPointer = std::variant<bool*, int*, unsigned*, std::int64_t*, float*, double*, std::string*,
                                      std::vector<double>*, std::vector<std::string>*>;

/// What its owner declares of a parameter, without the value.
struct Parameter {
  std::string name;                     ///< as the member and the key in a configuration file
  std::string unit;                     ///< SI: "m", "rad/s"; "" for a number without unit
  Range range;                          ///< for every number in the value
  std::string comment;                  ///< one sentence: what it does
  std::vector<std::string> attributes;  ///< words by which a program chooses parameters, as "feedback"
  std::vector<std::string> words;       ///< of a text: what it may be; empty: anything
  std::string defaultText;              ///< the declared value as text; filled by ParameterList::add

  bool has(const std::string& attribute) const;
};

/// The parameters of one type of owner (a module or a struct of PARAMETERS), in the order of their
/// declaration.
class ParameterList {
public:
  using Pointer = ParameterPointer (*)(void* owner);
  using GroupPointer = void* (*)(void* owner);
  struct Entry {
    Parameter parameter;        ///< of a group only the name and the comment
    Pointer pointer = nullptr;  ///< null: a group
    const ParameterList* group = nullptr;
    GroupPointer groupOf = nullptr;
  };

  ParameterList();
  ~ParameterList();
  ParameterList(const ParameterList&);
  ParameterList& operator=(const ParameterList&);

  bool add(Parameter parameter, Pointer pointer);
  bool addGroup(std::string_view name, std::string_view comment, const ParameterList& group,
                GroupPointer groupOf);
  /// What PARAMETER and PARAMETER_CHOICE call, once for each of the hundreds that there are: the work is done
  /// here, not where they stand.
  bool declare(const char* name, const char* unit, const Range& range, const char* comment,
               std::initializer_list<const char*> attributes, const ParameterPointer& value, Pointer pointer);
  bool declareChoice(const char* name, const char* comment, std::initializer_list<const char*> words,
                     const char* value, Pointer pointer);

  const std::vector<Entry>& entries() const { return entries_; }
  bool empty() const { return entries_.empty(); }

  /// Calls visitor(path, parameter, pointer) for every parameter of `owner`, those of groups with the group's
  /// name before them: "walk.maxForward".
  template <typename Visitor>
  void visit(void* owner, Visitor&& visitor, const std::string& prefix = "") const {
    for (const Entry& entry : entries_) {
      const std::string path = prefix + entry.parameter.name;
      if (entry.group) {
        entry.group->visit(entry.groupOf(owner), visitor, path + ".");
      } else {
        visitor(path, entry.parameter, entry.pointer(owner));
      }
    }
  }
  /// The paths that visit() would name.
  std::vector<std::string> paths() const;

private:
  void collectPaths(const std::string& prefix, std::vector<std::string>& paths) const;

  std::vector<Entry> entries_;
};

/// The value as it would stand in a configuration file: "0.5", "true", "[1, 2]". Numbers keep all their
/// digits.
std::string parameterText(const ParameterPointer& value);
/// "bool", "int", "double", "text", "list of numbers", ...
std::string parameterType(const ParameterPointer& value);
/// A copy of the value and its way back.
using ParameterValue = std::variant<bool, int, unsigned, std::int64_t, float, double, std::string,
                                    std::vector<double>, std::vector<std::string>>;
ParameterValue parameterValue(const ParameterPointer& value);
void setParameterValue(const ParameterPointer& target, const ParameterValue& value);

/// "" if every number is finite and in the parameter's range and a text is one of its words; otherwise what
/// is wrong, as "must be within [0, 1], not 2".
std::string parameterFault(const Parameter& parameter, const ParameterPointer& value);

}  // namespace plumbline

/// Begins the parameters of a struct. A parameter is declared once, with all that is known of it:
///
///     struct WalkToPose {
///       PARAMETERS(WalkToPose)
///       PARAMETER(double, maxForward, 0.5, "m/s", Range(0.01, 3), "fastest walk forward")
///       PARAMETER_GROUP(Approach, approach, "way around the ball")  // Approach has PARAMETERS of its own
///     };
#define PARAMETERS(Name)                               \
  static ::plumbline::ParameterList& parameterList() { \
    static ::plumbline::ParameterList list;            \
    return list;                                       \
  }                                                    \
  static Name* plumblineOwner(void* owner) { return static_cast<Name*>(owner); }

/// PARAMETER(type, name, default, unit, range, comment, attributes...) in PARAMETERS or in a MODULE. A
/// default with commas outside parentheses is put in parentheses.
#define PARAMETER(Type, name_, default_, unit_, range_, comment_, ...)                     \
public:                                                                                    \
  Type name_ = default_;                                                                   \
  static ::plumbline::ParameterPointer plumblinePointer_##name_(void* owner) {             \
    return &plumblineOwner(owner)->name_;                                                  \
  }                                                                                        \
  static bool plumblineDeclare_##name_() {                                                 \
    Type value = default_;                                                                 \
    return parameterList().declare(#name_, unit_, range_, comment_, {__VA_ARGS__}, &value, \
                                   &plumblinePointer_##name_);                             \
  }                                                                                        \
  inline static const bool plumblineParameter_##name_ = plumblineDeclare_##name_();        \
  static void plumblineEndOfParameter_##name_() {}

/// A parameter of type std::string that is one of the words that follow the comment.
#define PARAMETER_CHOICE(name_, default_, comment_, ...)                                                   \
public:                                                                                                    \
  std::string name_ = default_;                                                                            \
  static ::plumbline::ParameterPointer plumblinePointer_##name_(void* owner) {                             \
    return &plumblineOwner(owner)->name_;                                                                  \
  }                                                                                                        \
  inline static const bool plumblineParameter_##name_ =                                                    \
      parameterList().declareChoice(#name_, comment_, {__VA_ARGS__}, default_, &plumblinePointer_##name_); \
  static void plumblineEndOfParameter_##name_() {}

/// A member of a type with PARAMETERS; in a configuration file its parameters stand in a map of the member's
/// name.
#define PARAMETER_GROUP(Type, name_, comment_)                                                      \
public:                                                                                             \
  Type name_;                                                                                       \
  static void* plumblineGroupOf_##name_(void* owner) { return &plumblineOwner(owner)->name_; }      \
  inline static const bool plumblineGroup_##name_ =                                                 \
      parameterList().addGroup(#name_, comment_, Type::parameterList(), &plumblineGroupOf_##name_); \
  static void plumblineEndOfGroup_##name_() {}
