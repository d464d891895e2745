// Counts<T>: base of a problem's Tally. One list names each count; summation over ranks,
// serialisation and the names in reports follow from it.
//
//   struct Tally : engine::Counts<Tally> {
//     std::uint64_t opened = 0;
//     engine::Least least_bound;
//     static constexpr auto fields() {
//       return std::tuple{field("opened", &Tally::opened),
//                         field("least_bound", &Tally::least_bound)};
//     }
//   };
#pragma once

#include <algorithm>
#include <limits>
#include <tuple>

namespace kusabi::engine {

/// A minimum; infinite if empty. Addition takes the smaller value.
struct Least {
  double value = std::numeric_limits<double>::infinity();

  Least& operator+=(const Least& other) {
    value = std::min(value, other.value);
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& value;
  }
};

/// A count and its name.
template <class Tally, class Value>
struct CountField {
  const char* name;
  Value Tally::*member;
};

/// Base of a tally `T`, which has `static constexpr auto fields()`, a tuple of CountFields.
template <class T>
struct Counts {
  /// Calls visit(name, value) for each, in the order of the list.
  template <class Visit>
  void each(Visit visit) const {
    std::apply([&](const auto&... fields) { (visit(fields.name, own().*fields.member), ...); },
               T::fields());
  }

  T& operator+=(const T& other) {
    std::apply(
        [&](const auto&... fields) { ((own().*fields.member += other.*fields.member), ...); },
        T::fields());
    return own();
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    std::apply([&](const auto&... fields) { (archive & ... & (own().*fields.member)); },
               T::fields());
  }

 protected:
  template <class Value>
  static constexpr CountField<T, Value> field(const char* name, Value T::*member) {
    return {name, member};
  }

 private:
  T& own() { return static_cast<T&>(*this); }
  const T& own() const { return static_cast<const T&>(*this); }
};

}  // namespace kusabi::engine
