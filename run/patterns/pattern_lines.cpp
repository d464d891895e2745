// Lines of the parts: a key, by which they are sorted, a blank, and the JSON of the pattern.
#include "run/patterns/pattern_lines.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "run/output/line_sorter.hpp"
#include "run/output/values.hpp"
#include "run/patterns/patterns_report.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

constexpr char in_contact = 'u';
constexpr char is_separated = 'r';
constexpr std::size_t place_width = 9;  // a digit of the kind and eight of the block

// Kind of the leaf, its block, and the state of each candidate.
std::string key_of(const wedged::Configuration& leaf, std::size_t candidates) {
  using wedged::LeafState;
  const int kind = leaf.state == LeafState::marginal    ? 1
                   : leaf.state == LeafState::undecided ? 2
                                                        : 0;
  auto key = fmt::format("{}{:08x}", kind, leaf.block);
  key.resize(place_width + candidates, '.');
  for (const int i : leaf.pattern.contact)
    key[place_width + static_cast<std::size_t>(i)] = in_contact;
  for (const int i : leaf.pattern.separated)
    key[place_width + static_cast<std::size_t>(i)] = is_separated;
  return key;
}

std::uint32_t block_of(std::string_view key) {
  return static_cast<std::uint32_t>(
      std::stoul(std::string(key.substr(1, place_width - 1)), nullptr, 16));
}

wedged::SignPattern pattern_of(std::string_view key) {
  wedged::SignPattern pattern;
  const auto states = key.substr(place_width);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == in_contact) pattern.contact.insert(static_cast<int>(i));
    if (states[i] == is_separated) pattern.separated.insert(static_cast<int>(i));
  }
  return pattern;
}

std::string_view key_in(std::string_view line) {
  return line.substr(0, line.find(' '));
}

// Lexicographic order of the increasing lists of the candidates in one state.
int compared(std::string_view a, std::string_view b, char state) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i] == state) == (b[i] == state)) continue;
    // The list that has i comes first unless the other one has ended.
    const bool first_has = a[i] == state;
    const auto other = (first_has ? b : a).substr(i + 1);
    return (other.find(state) != std::string_view::npos) == first_has ? -1 : 1;
  }
  return 0;
}

// Order of wedged::maximal_cones.
bool comes_before(std::string_view first, std::string_view second) {
  const auto a = key_in(first);
  const auto b = key_in(second);
  if (const int place = a.substr(0, place_width).compare(b.substr(0, place_width)); place != 0)
    return place < 0;
  const int by_contact = compared(a.substr(place_width), b.substr(place_width), in_contact);
  if (by_contact != 0) return by_contact < 0;
  return compared(a.substr(place_width), b.substr(place_width), is_separated) < 0;
}

// The names of inactive candidates, which are known at the end only, before the state of a pattern.
std::string inactive_member(const problems::WedgedProblem& problem,
                            const support::IndexSet& inactive) {
  if (inactive.empty()) return {};
  return fmt::format("\"inactive\":{},", json_line(candidate_names(problem, inactive)));
}

}  // namespace

ordered_json lean_pattern(const problems::WedgedProblem& problem, const wedged::Configuration& leaf,
                          const support::IndexSet& inactive) {
  auto json = pattern_json(problem, leaf.block, leaf.pattern, inactive);
  json["state"] = state_name(leaf.state);
  json["margin"] = leaf.lower;
  json["margin_upper"] = leaf.upper;
  json["reaction"] = block_rows(problem, leaf.block, leaf.reaction);
  return json;
}

ordered_json firmness_json(const std::optional<wedged::Firmness>& firmness) {
  if (!firmness) return nullptr;
  return {{"low", answer::number_or_null(firmness->low)},
          {"low_out", answer::number_or_null(firmness->low_out)},
          {"high", answer::number_or_null(firmness->high)},
          {"high_out", answer::number_or_null(firmness->high_out)}};
}

PatternLines::PatternLines(Session& session, const problems::WedgedProblem& problem,
                           const PartsOwner& owner, const wedged::PatternFirmness* firmness,
                           bool goes_on, bool finished)
    : problem_(problem), owner_(owner), firmness_(firmness) {
  if (!finished) parts_.emplace(session, owner, goes_on);
}

std::string PatternLines::line_of(const wedged::Configuration& leaf,
                                  const support::IndexSet& inactive) const {
  auto json = lean_pattern(problem_, leaf, inactive);
  if (firmness_ != nullptr) json["firmness"] = firmness_json(firmness_->of(leaf));
  return json_line(json);
}

void PatternLines::add(const wedged::Configuration& leaf) {
  parts_->put(fmt::format("{} {}\n", key_of(leaf, problem_.contact_names.size()), line_of(leaf)));
}

void PatternLines::close(wedged::PatternFindings& findings) {
  if (parts_) parts_->close();
  numbers_.assign(findings.largest.size(), 0);
  if (findings.flat == 0) return;
  const auto parts = parts_ ? parts_->all() : parts_of_finished(owner_);
  if (parts.empty()) return keep_flat_of_earlier(findings);
  read_parts(parts, [&](std::string_view line) {
    const auto key = key_in(line);
    const auto block = block_of(key);
    const auto pattern = pattern_of(key);
    findings.remove_flat([&](const auto& flat) {
      return flat.block == block && wedged::within(flat.pattern, pattern);
    });
  });
}

// Of a finished run: its file has the lines of the flat patterns that are contained in no other.
void PatternLines::keep_flat_of_earlier(wedged::PatternFindings& findings) const {
  std::ifstream file(owner_.name, std::ios::binary);
  const auto inactive = findings.inactive();
  std::set<std::string> lines;
  for (const auto& leaf : findings.leaves) lines.insert(line_of(leaf, inactive));
  std::set<std::string> kept;
  for (std::string line; next_line(file, line);) {
    if (lines.contains(line)) kept.insert(line);
  }
  findings.remove_flat([&](const auto& flat) { return !kept.contains(line_of(flat, inactive)); });
}

bool PatternLines::write(std::ostream& out, const std::string& head,
                         const wedged::PatternFindings& findings) {
  const auto inactive = findings.inactive();
  std::vector<std::string> largest;
  largest.reserve(findings.largest.size());
  for (const auto& leaf : findings.largest) largest.push_back(line_of(leaf, inactive));
  const auto parts = parts_ ? parts_->all() : parts_of_finished(owner_);
  if (parts.empty()) {
    count_earlier(head, largest);
    return false;
  }
  LineSorter sorter(owner_.name, comes_before);
  read_parts(parts, [&](std::string_view line) { sorter.add(line); });
  for (const auto& leaf : findings.leaves) {
    sorter.add(fmt::format("{} {}", key_of(leaf, problem_.contact_names.size()), line_of(leaf)));
  }
  out << head << '\n';
  const auto member = inactive_member(problem_, inactive);
  std::size_t number = 0;
  std::string text;
  sorter.each([&](std::string_view line) {
    text = line.substr(line.find(' ') + 1);
    // An unescaped quotation mark is not within a name.
    if (!member.empty()) text.insert(text.find(R"("state":)"), member);
    out << text << '\n';
    note_number(largest, text, ++number);
  });
  return true;
}

// The file of an earlier run, which has joined and removed the parts.
void PatternLines::count_earlier(const std::string& head, const std::vector<std::string>& largest) {
  std::ifstream file(owner_.name, std::ios::binary);
  std::string line;
  if (!next_line(file, line) || line != head) {
    throw std::runtime_error(
        fmt::format("{}: neither the patterns nor their parts exist; expected one of them, or "
                    "another --resume",
                    owner_.name));
  }
  for (std::size_t number = 1; next_line(file, line); ++number) note_number(largest, line, number);
}

void PatternLines::note_number(const std::vector<std::string>& largest, const std::string& line,
                               std::size_t number) {
  const auto found = std::ranges::find(largest, line);
  if (found != largest.end()) numbers_[static_cast<std::size_t>(found - largest.begin())] = number;
}

void PatternLines::end(bool goes_on) {
  if (!goes_on) return remove_parts(owner_.name);
  if (parts_) parts_->require();
}

}  // namespace kusabi::run
