// Times of one core, rounded up: trees of faces with all their nodes in contact.
#include "run/show/expectation.hpp"

#include <array>
#include <span>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

struct Cost {
  std::size_t candidates;  ///< up to so many
  const char* bracket;     ///< a proved bracket of kusabi critical
  const char* list;        ///< the list of all patterns
};

constexpr std::array in_the_plane{
    Cost{30, "in about a second", "in about a second"},
    Cost{60, "in seconds", "in seconds to a minute"},
    Cost{200, "in seconds to minutes", "may not end (kusabi patterns --exists finds one pattern)"},
};
constexpr std::array in_space{
    Cost{30, "in about a second", "in about a second"},
    Cost{64, "in seconds", "in seconds to minutes"},
    Cost{150, "in seconds to a minute", "in minutes, or it may not end"},
    Cost{250, "in about a minute", "may not end"},
};

const Cost* cost_of(std::span<const Cost> costs, std::size_t candidates) {
  for (const auto& cost : costs) {
    if (candidates <= cost.candidates) return &cost;
  }
  return nullptr;
}

// The least n for which `every = n` leaves at most 60 candidates.
std::size_t thinning(std::size_t candidates) {
  constexpr std::size_t comfortable = 60;
  return (candidates + comfortable - 1) / comfortable;
}

}  // namespace

std::string expectation(int dimension, std::size_t candidates) {
  if (candidates == 0) return {};
  const auto* const cost =
      dimension == 2 ? cost_of(in_the_plane, candidates) : cost_of(in_space, candidates);
  auto text = cost == nullptr
                  ? std::string(
                        "the bracket (critical) takes minutes or more; the list of "
                        "all patterns may not end")
                  : fmt::format("the bracket (critical) {}; the list of all patterns {}",
                                cost->bracket, cost->list);
  if (const auto every = thinning(candidates); every > 1) {
    text += fmt::format("; every = {} in [[contact]] leaves about {} candidates", every,
                        candidates / every);
  }
  return text;
}

}  // namespace kusabi::run
