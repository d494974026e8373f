#pragma once
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "framework/InStream.h"
#include "framework/OutStream.h"

// How each supported type is broken down to the shapes a stream knows. A type of one's own becomes
// streamable by a stream method (see Streamable.h) or, where the class cannot be changed, by a
// specialisation of StreamType with the two functions below. Includes no Eigen: its types are known by shape.
namespace plumbline {

template <typename T>
struct StreamType;

/// Anything with `void stream(InStream*, OutStream*)`; the base class Streamable is not needed.
template <typename T>
concept HasStreamMethod = requires(T& value, InStream* in, OutStream* out) {
  value.stream(in, out);
};

template <typename T>
requires HasStreamMethod<T>
struct StreamType<T> {
  static void write(OutStream& out, const T& value) {
    if (out.check()) return const_cast<T&>(value).stream(nullptr, &out);
    out.beginObject();
    const_cast<T&>(value).stream(nullptr, &out);
    out.endObject();
  }
  static void read(InStream& in, T& value) {
    in.beginObject();
    if (in.ok()) value.stream(&in, nullptr);
    in.endObject();
  }
};

template <>
struct StreamType<bool> {
  static void write(OutStream& out, bool value) {
    if (!out.check()) out.writeBool(value);
  }
  static void read(InStream& in, bool& value) { in.readBool(value); }
};

template <>
struct StreamType<char> {
  static void write(OutStream& out, char value) {
    if (!out.check()) out.writeChar(value);
  }
  static void read(InStream& in, char& value) { in.readChar(value); }
};

template <>
struct StreamType<float> {
  static void write(OutStream& out, float value) {
    if (NumberCheck* check = out.check()) return check->see(static_cast<double>(value));
    out.writeFloat(value);
  }
  static void read(InStream& in, float& value) { in.readFloat(value); }
};

template <>
struct StreamType<double> {
  static void write(OutStream& out, double value) {
    if (NumberCheck* check = out.check()) return check->see(value);
    out.writeDouble(value);
  }
  static void read(InStream& in, double& value) { in.readDouble(value); }
};

template <>
struct StreamType<std::string> {
  static void write(OutStream& out, const std::string& value) {
    if (!out.check()) out.writeString(value);
  }
  static void read(InStream& in, std::string& value) { in.readString(value); }
};

template <std::signed_integral T>
struct StreamType<T> {
  static void write(OutStream& out, T value) {
    if (!out.check()) out.writeSigned(value, sizeof(T));
  }
  static void read(InStream& in, T& value) {
    std::int64_t wide = value;
    in.readSigned(wide, sizeof(T));
    value = static_cast<T>(wide);
  }
};

template <std::unsigned_integral T>
struct StreamType<T> {
  static void write(OutStream& out, T value) {
    if (!out.check()) out.writeUnsigned(value, sizeof(T));
  }
  static void read(InStream& in, T& value) {
    std::uint64_t wide = value;
    in.readUnsigned(wide, sizeof(T));
    value = static_cast<T>(wide);
  }
};

/// As its underlying integer. An enumerator named `count` bounds what is read.
template <typename T>
requires std::is_enum_v<T>
struct StreamType<T> {
  using Integer = std::underlying_type_t<T>;
  static_assert(
      requires { T{0}; }, "give the enum an underlying type: a value read into it could be undefined");
  static void write(OutStream& out, T value) { StreamType<Integer>::write(out, static_cast<Integer>(value)); }
  static void read(InStream& in, T& value) {
    Integer integer = static_cast<Integer>(value);
    StreamType<Integer>::read(in, integer);
    if constexpr (requires { T::count; }) {
      if (in.ok() && (integer < 0 || integer >= static_cast<Integer>(T::count))) {
        return in.fail("enum value " + std::to_string(integer) + " out of range");
      }
    }
    value = static_cast<T>(integer);
  }
};

template <typename T, std::size_t n>
struct StreamType<std::array<T, n>> {
  static void write(OutStream& out, const std::array<T, n>& value) {
    out.beginList(n, false);
    if constexpr (BlockNumber<T>) {
      out.writeBlock(numberType<T>(), value.data(), n);
    } else {
      for (const T& element : value) StreamType<T>::write(out, element);
    }
    out.endList();
  }
  static void read(InStream& in, std::array<T, n>& value) {
    in.beginObject();
    if constexpr (BlockNumber<T>) {
      in.readBlock(numberType<T>(), value.data(), n);
    } else {
      for (T& element : value) {
        if (in.ok()) StreamType<T>::read(in, element);
      }
    }
    in.endObject();
  }
};

template <typename T>
struct StreamType<std::vector<T>> {
  static void write(OutStream& out, const std::vector<T>& value) {
    if (out.check() && !BlockNumber<T>) {
      for (const auto& element : value) StreamType<T>::write(out, element);
      return;
    }
    out.beginList(value.size(), true);
    if constexpr (BlockNumber<T>) {
      out.writeBlock(numberType<T>(), value.data(), value.size());
    } else {
      for (const auto& element : value) StreamType<T>::write(out, element);
    }
    out.endList();
  }
  static void read(InStream& in, std::vector<T>& value) {
    in.beginList();
    if constexpr (BlockNumber<T>) {
      if (const auto count = in.blockAhead(numberType<T>())) {
        value.resize(*count);  // all of it is there
        in.readBlock(numberType<T>(), value.data(), *count);
        return in.endList();
      }
    }
    // Grows with what really arrives, so that a lie about the length takes no memory.
    std::vector<T> elements;
    while (in.nextElement()) {
      T element{};
      StreamType<T>::read(in, element);
      if (!in.ok()) return;
      elements.push_back(std::move(element));
    }
    in.endList();
    if (in.ok()) value = std::move(elements);
  }
};

/// A list of no or one element.
template <typename T>
struct StreamType<std::optional<T>> {
  static void write(OutStream& out, const std::optional<T>& value) {
    out.beginList(value ? 1 : 0, true);
    if (value) StreamType<T>::write(out, *value);
    out.endList();
  }
  static void read(InStream& in, std::optional<T>& value) {
    std::optional<T> result;
    in.beginList();
    while (in.nextElement()) {
      if (result) return in.fail("an optional value holds one element at most");
      T element{};
      StreamType<T>::read(in, element);
      if (!in.ok()) return;
      result = std::move(element);
    }
    in.endList();
    if (in.ok()) value = std::move(result);
  }
};

template <typename A, typename B>
struct StreamType<std::pair<A, B>> {
  static void write(OutStream& out, const std::pair<A, B>& value) {
    out.beginObject();
    out.label("first");
    StreamType<A>::write(out, value.first);
    out.label("second");
    StreamType<B>::write(out, value.second);
    out.endObject();
  }
  static void read(InStream& in, std::pair<A, B>& value) {
    in.beginObject();
    in.label("first");
    if (in.ok()) StreamType<A>::read(in, value.first);
    in.label("second");
    if (in.ok()) StreamType<B>::read(in, value.second);
    in.endObject();
  }
};

/// Eigen's matrices and vectors of fixed size.
template <typename T>
concept FixedMatrix = requires(T& m) {
  T::RowsAtCompileTime;
  T::ColsAtCompileTime;
  m.coeffRef(0, 0);
}
&&(T::RowsAtCompileTime > 0) && (T::ColsAtCompileTime > 0);

/// A vector is an object with the members x y z w (as far as it has them; longer ones have no labels), a
/// matrix a list of rows.
template <FixedMatrix T>
struct StreamType<T> {
  using Scalar = typename T::Scalar;
  static constexpr int rows = T::RowsAtCompileTime;
  static constexpr int columns = T::ColsAtCompileTime;
  static constexpr int size = rows * columns;
  static constexpr bool isVector = rows == 1 || columns == 1;
  static constexpr std::string_view names[] = {"x", "y", "z", "w"};

  static void write(OutStream& out, const T& value) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      if (NumberCheck* check = out.check()) {
        for (int i = 0; i < size; i++) check->see(static_cast<double>(value.coeff(i % rows, i / rows)));
        return;
      }
    }
    out.beginObject();
    if constexpr (BlockNumber<Scalar>) {
      if (out.flat()) {
        std::array<Scalar, size> rowByRow;
        for (int i = 0; i < size; ++i) rowByRow[i] = value.coeff(i / columns, i % columns);
        out.writeBlock(numberType<Scalar>(), rowByRow.data(), size);
        return out.endObject();
      }
    }
    for (int i = 0; i < size; ++i) {
      if constexpr (isVector) {
        if (size <= 4) out.label(names[i < 4 ? i : 0]);
        StreamType<Scalar>::write(out, value.coeff(i));
      } else {
        if (i % columns == 0) out.beginObject();
        StreamType<Scalar>::write(out, value.coeff(i / columns, i % columns));
        if (i % columns == columns - 1) out.endObject();
      }
    }
    out.endObject();
  }
  static void read(InStream& in, T& value) {
    in.beginObject();
    if constexpr (BlockNumber<Scalar>) {
      if (in.flat() && in.ok()) {
        std::array<Scalar, size> rowByRow{};
        in.readBlock(numberType<Scalar>(), rowByRow.data(), size);
        for (int i = 0; i < size && in.ok(); ++i) value.coeffRef(i / columns, i % columns) = rowByRow[i];
        return in.endObject();
      }
    }
    for (int i = 0; i < size && in.ok(); ++i) {
      if constexpr (isVector) {
        if (size <= 4) in.label(names[i < 4 ? i : 0]);
        if (in.ok()) StreamType<Scalar>::read(in, value.coeffRef(i));
      } else {
        if (i % columns == 0) in.beginObject();
        if (in.ok()) StreamType<Scalar>::read(in, value.coeffRef(i / columns, i % columns));
        if (i % columns == columns - 1) in.endObject();
      }
    }
    in.endObject();
  }
};

/// Eigen's rigid transforms (Isometry3d): `{[rotation] {rows} [translation] {x y z}}`.
template <typename T>
concept RigidTransform = requires(T& t) {
  t.linear();
  t.translation();
  t.makeAffine();
};

template <RigidTransform T>
struct StreamType<T> {
  using Linear = std::remove_cvref_t<decltype(std::declval<const T&>().linear().eval())>;
  using Translation = std::remove_cvref_t<decltype(std::declval<const T&>().translation().eval())>;
  static void write(OutStream& out, const T& value) {
    if (out.check()) {
      StreamType<Linear>::write(out, value.linear());
      return StreamType<Translation>::write(out, value.translation());
    }
    out.beginObject();
    out.label("rotation");
    StreamType<Linear>::write(out, value.linear());
    out.label("translation");
    StreamType<Translation>::write(out, value.translation());
    out.endObject();
  }
  static void read(InStream& in, T& value) {
    Linear linear = value.linear();
    Translation translation = value.translation();
    in.beginObject();
    in.label("rotation");
    if (in.ok()) StreamType<Linear>::read(in, linear);
    in.label("translation");
    if (in.ok()) StreamType<Translation>::read(in, translation);
    in.endObject();
    if (!in.ok()) return;
    value.linear() = linear;
    value.translation() = translation;
    value.makeAffine();
  }
};

/// Eigen's quaternions, as x y z w.
template <typename T>
concept QuaternionLike = requires(T& q) {
  q.coeffs();
  q.toRotationMatrix();
};

template <QuaternionLike T>
struct StreamType<T> {
  using Coefficients = std::remove_cvref_t<decltype(std::declval<T&>().coeffs())>;
  static void write(OutStream& out, const T& value) { StreamType<Coefficients>::write(out, value.coeffs()); }
  static void read(InStream& in, T& value) { StreamType<Coefficients>::read(in, value.coeffs()); }
};

}  // namespace plumbline
