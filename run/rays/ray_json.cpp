// States and reactions of a ray.
#include "run/rays/ray_json.hpp"

#include <string_view>
#include <utility>

#include "run/output/values.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;

namespace {

constexpr const char* with_gap = "separates";
constexpr const char* inactive = "idle";

}  // namespace

RayState state_of(const rays::Supports& supports, int candidate) {
  const auto here = rays::bit(candidate);
  if ((supports.separated() & here) != 0) return {'o', with_gap};
  if ((supports.sticking() & here) != 0) return {'x', "sticks"};
  if ((supports.sliding_up() & here) != 0) return {'+', "slides +"};
  if ((supports.sliding_down() & here) != 0) return {'-', "slides -"};
  return {'.', inactive};
}

ordered_json lean_ray(const rays::Supports& supports, const rays::Ray& ray) {
  auto words = ordered_json::array();
  for (int i = 0; 2 * i < ray.reaction.size(); ++i) words.push_back(state_of(supports, i).word);
  return {{"state", std::move(words)}, {"reaction", candidate_rows(numbers(ray.reaction), 2)}};
}

rays::Cone cone_from_states(const ordered_json& states) {
  rays::Cone cone;
  for (int i = 0; const auto& state : states) {
    const auto here = rays::bit(i++);
    const auto word = state.get<std::string_view>();
    if (word == with_gap) {
      cone.separated |= here;
    } else if (word != inactive) {
      cone.reaction |= here;
    }
  }
  return cone;
}

}  // namespace kusabi::run
