#pragma once
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <type_traits>

// What a compiler would warn of that knows the numbers no more, or another operator.
#pragma GCC diagnostic ignored "-Wnarrowing"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

/// Changes of the code behind switches, in the copy of the tree that scripts/mutation.sh builds:
/// PLUMBLINE_MUTANT in the environment is the number of the one change that a run of the tests has. None
/// without it.
namespace mutation {
inline constexpr int mostChanges = 20000;
inline bool ran[mostChanges];              ///< by number: whether the place was reached, for Recorder.cpp
inline constexpr int doesNotCompile = 97;  ///< how a program ends where the other operator would not

inline int chosen() {
  static const int number = [] {
    const char* text = std::getenv("PLUMBLINE_MUTANT");
    return text ? std::atoi(text) : 0;
  }();
  return number;
}

/// What stood there, or what is put there. For constants: their uses are what is noted.
template <typename T>
T switched(int number, T was, T other) {
  return chosen() == number ? other : was;
}

/// Notes that the place of these changes was reached.
template <typename... Numbers>
void seen(Numbers... numbers) {
  ((ran[numbers] = true), ...);
}

template <typename T>
T mutated(int number, T was, T other) {
  seen(number);
  return switched(number, was, other);
}

/// An operator: `a < b` becomes `a < mutation::infix<7, std::less<>, std::less_equal<>> > b`, which computes
/// as before where the two operators bind alike.
template <int number, typename Was, typename Other>
struct Infix {};
template <int number, typename Was, typename Other>
inline constexpr Infix<number, Was, Other> infix{};

template <typename Left, int number, typename Was, typename Other>
struct Half {
  const Left& left;

  template <typename Right>
  auto with(const Right& right) const {
    seen(number);
    using Result = std::invoke_result_t<Was, const Left&, const Right&>;
    if constexpr (requires { typename Result::PlainObject; }) {  // an expression of Eigen's
      return value<typename Result::PlainObject>(right);
    } else {
      return value<Result>(right);
    }
  }

private:
  template <typename Value, typename Right>
  Value value(const Right& right) const {
    if (chosen() == number) {
      if constexpr (requires { Value(Other{}(left, right)); }) return Value(Other{}(left, right));
      std::_Exit(doesNotCompile);
    }
    return Was{}(left, right);
  }
};

#define MUTATION_INFIX(BEFORE, AFTER)                                                           \
  template <typename Left, int number, typename Was, typename Other>                            \
  Half<Left, number, Was, Other> operator BEFORE(const Left& left, Infix<number, Was, Other>) { \
    return {left};                                                                              \
  }                                                                                             \
  template <typename Left, int number, typename Was, typename Other, typename Right>            \
  auto operator AFTER(Half<Left, number, Was, Other> half, const Right& right) {                \
    return half.with(right);                                                                    \
  }
MUTATION_INFIX(<, >)
MUTATION_INFIX(==, ==)
MUTATION_INFIX(+, +)
MUTATION_INFIX(*, *)
#undef MUTATION_INFIX

/// std::min and std::max of two, one in the other's place.
template <int number, typename T>
T min(const T& a, const T& b) {
  seen(number);
  return chosen() == number ? std::max(a, b) : std::min(a, b);
}
template <int number, typename T>
T max(const T& a, const T& b) {
  seen(number);
  return chosen() == number ? std::min(a, b) : std::max(a, b);
}
}  // namespace mutation
