// Lines of the parts: a key, by which they are sorted, a blank, and the JSON of the ray.
#include "run/rays/ray_lines.hpp"

#include <charconv>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "run/output/values.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using rays::Candidates;

std::size_t digits_of_word(int candidates) {
  constexpr std::size_t bits = 4;  // of a hexadecimal digit
  return (static_cast<std::size_t>(candidates) + bits - 1) / bits;
}

// The first candidate becomes the highest bit, and the reverse.
Candidates reversed(Candidates word, int candidates) {
  Candidates result = 0;
  for (int i = 0; i < candidates; ++i) result = (result << 1U) | (word >> i & 1U);
  return result;
}

// Four words in hexadecimal, whose order as text is rays::comes_before.
std::string key_of(const rays::ZeroSet& zero, int candidates) {
  const auto digits = digits_of_word(candidates);
  std::string key;
  for (const auto word : {zero.p & zero.q, zero.u, zero.p, zero.q})
    key += fmt::format("{:0{}x}", reversed(word, candidates), digits);
  return key;
}

rays::Cone cone_of_key(std::string_view key, int candidates) {
  constexpr int hexadecimal = 16;
  const auto digits = digits_of_word(candidates);
  const auto nonzero = [&](std::size_t place) {
    Candidates word = 0;
    const auto* const first = key.data() + place * digits;
    std::from_chars(first, first + digits, word, hexadecimal);
    return rays::first_candidates(candidates) & ~reversed(word, candidates);
  };
  return {.reaction = nonzero(0), .separated = nonzero(1)};
}

}  // namespace

RayLines::RayLines(Session& session, const rays::ReactionCone& cone, const PartsOwner& owner,
                   bool goes_on, bool finished)
    : cone_(cone), owner_(owner), is_first_(session.is_first()) {
  if (!finished) parts_.emplace(session, owner, goes_on);
}

std::string RayLines::line_of(const rays::ZeroSet& zero, const rays::Ray& ray) const {
  return fmt::format("{} {}", key_of(zero, cone_.candidates()),
                     json_line(lean_ray({zero, cone_.all()}, ray)));
}

void RayLines::add(const rays::ZeroSet& zero, const rays::Ray& ray) {
  parts_->put(line_of(zero, ray) + '\n');
}

rays::ConesOfRays RayLines::close(wedged::RayFindings& findings) {
  rays::ConesOfRays cones;
  if (parts_) parts_->close();
  if (!is_first_) return cones;
  const auto parts = parts_ ? parts_->all() : parts_of_finished(owner_);
  if (parts.empty() && findings.kept > 0) return cones_of_earlier();
  const auto key_length = 4 * digits_of_word(cone_.candidates());
  sorter_.emplace(owner_.name, [key_length](std::string_view a, std::string_view b) {
    return a.substr(0, key_length) < b.substr(0, key_length);
  });
  read_parts(parts, [&](std::string_view line) {
    sorter_->add(line);
    cones.add(cone_of_key(line, cone_.candidates()));
  });
  for (const auto& zero : findings.rays) {
    sorter_->add(line_of(zero, cone_.ray(zero, findings.health)));
    cones.add(rays::cone_of({zero, cone_.all()}));
  }
  return cones;
}

// The file of an earlier run, which has joined and removed the parts.
rays::ConesOfRays RayLines::cones_of_earlier() const {
  std::ifstream file(owner_.name, std::ios::binary);
  std::string line;
  next_line(file, line);
  rays::ConesOfRays cones;
  while (next_line(file, line)) {
    const auto json = nlohmann::ordered_json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("state")) cones.add(cone_from_states(json["state"]));
  }
  return cones;
}

bool RayLines::write(std::ostream& out, const std::string& head) {
  if (!sorter_) {
    std::ifstream file(owner_.name, std::ios::binary);
    std::string line;
    if (next_line(file, line) && line == head) return false;
    throw std::runtime_error(
        fmt::format("{}: neither the rays nor their parts exist; expected one of them, or another "
                    "--resume",
                    owner_.name));
  }
  out << head << '\n';
  std::size_t number = 0;
  sorter_->each([&](std::string_view line) {
    // The number is the first key of the object.
    out << R"({"number":)" << ++number << ',' << line.substr(line.find('{') + 1) << '\n';
  });
  return true;
}

void RayLines::end(bool goes_on) {
  if (!goes_on) return remove_parts(owner_.name);
  if (parts_) parts_->require();
}

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
