// Sense of an objective: the engine minimises; a problem that maximises sees its own values.
#pragma once

#include <type_traits>

namespace kusabi::engine {

/// A problem that states the sense of its objective by `static constexpr bool maximises`.
template <class P>
concept WithSense = requires {
  typename std::bool_constant<P::maximises>;
};

template <class P>
inline constexpr bool is_maximising = [] {
  if constexpr (WithSense<P>) {
    return bool{P::maximises};
  } else {
    return false;
  }
}();

/// An objective or bound of `P` as the engine minimises it, and back.
template <class P>
constexpr double oriented(double value) {
  return is_maximising<P> ? 0.0 - value : value;  // not -value, which would show a zero as -0
}

}  // namespace kusabi::engine
