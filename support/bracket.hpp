// Bound, Bracket: a number that is known between two bounds. Every folder that reports such a
// number uses them, so that a bound and its standing are never apart.
#pragma once

#include <limits>
#include <optional>

namespace kusabi::support {

/// Standing of a bound, a list or another statement.
enum class Standing : bool {
  computed,  ///< in floating point, without a proof
  proved,    ///< holds including rounding errors
};

constexpr Standing proved_if(bool proved) {
  return proved ? Standing::proved : Standing::computed;
}

constexpr bool is_proved(Standing standing) {
  return standing == Standing::proved;
}

/// That of a conclusion from two statements.
constexpr Standing both(Standing one, Standing other) {
  return proved_if(is_proved(one) && is_proved(other));
}

struct Bound {
  double value = 0;
  Standing standing = Standing::computed;

  [[nodiscard]] bool proved() const { return is_proved(standing); }

  friend bool operator==(const Bound&, const Bound&) = default;
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& value& standing;
  }
};

inline bool is_proved(const std::optional<Bound>& bound) {
  return bound && bound->proved();
}

/// A number between two bounds. An absent bound is open: nothing is known on that side.
struct Bracket {
  std::optional<Bound> lower{}, upper{};

  /// Both bounds proved, as for a number known exactly.
  static Bracket proved(double lower, double upper) {
    return {Bound{lower, Standing::proved}, Bound{upper, Standing::proved}};
  }

  /// The lower bound; minus infinity if it is open.
  [[nodiscard]] double at_least() const {
    return lower ? lower->value : -std::numeric_limits<double>::infinity();
  }
  /// The upper bound; infinity if it is open.
  [[nodiscard]] double at_most() const {
    return upper ? upper->value : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double width() const { return at_most() - at_least(); }
  [[nodiscard]] bool has_proved_ends() const { return is_proved(lower) && is_proved(upper); }
  /// True if both bounds are proved and not further apart than `gap`.
  [[nodiscard]] bool proved_within(double gap) const { return has_proved_ends() && width() <= gap; }

  /// Bounds of minus the number. Minus zero is zero.
  [[nodiscard]] Bracket negative() const {
    const auto minus = [](const std::optional<Bound>& bound) -> std::optional<Bound> {
      if (!bound) return {};
      return Bound{0.0 - bound->value, bound->standing};
    };
    return {minus(upper), minus(lower)};
  }

  friend bool operator==(const Bracket&, const Bracket&) = default;
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    for (auto* const bound : {&lower, &upper}) {
      bool known = bound->has_value();
      auto end = bound->value_or(Bound{});
      archive& known& end;
      if constexpr (Archive::is_loading::value) {
        bound->reset();
        if (known) *bound = end;
      }
    }
  }
};

}  // namespace kusabi::support
