// Sets of nodes and elements.
#include "problems/files/abaqus/abaqus_groups.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// The numbers first, first + step, ..., last of a line of GENERATE.
struct Range {
  int first;
  int last;
  int step;
};

Range range(const MeshText& line) {
  const Range result{line.whole(0, "the first number", 1), line.whole(1, "the last number", 1),
                     line.fields() > 2 ? line.whole(2, "the step", 1) : 1};
  if (result.last < result.first) {
    line.fail(1, fmt::format("the last number is {}, below the first; expected FIRST, LAST, STEP",
                             result.last));
  }
  return result;
}

bool is_number(std::string_view field) {
  if (field.starts_with('-') || field.starts_with('+')) field.remove_prefix(1);
  return !field.empty() && std::ranges::all_of(field, [](unsigned char character) {
    return std::isdigit(character) != 0;
  });
}

/// The name in a field, which may be in quotes.
std::string_view unquoted(std::string_view field) {
  const bool quoted = field.size() > 1 && field.starts_with('"') && field.ends_with('"');
  return quoted ? field.substr(1, field.size() - 2) : field;
}

/// Removes repetitions and keeps the first occurrence.
void remove_repeated(std::vector<int>& numbers, std::size_t all) {
  std::vector<bool> seen(all, false);
  std::erase_if(numbers, [&](int number) {
    const bool again = seen[static_cast<std::size_t>(number)];
    seen[static_cast<std::size_t>(number)] = true;
    return again;
  });
}

/// Adds the entries of a set: each data line is a range or a list.
/// @param of_tag number of a tag, -1 if there is none  @param of_field numbers of a field
template <class OfTag, class OfField>
void read_set(AbaqusText& text, const AbaqusCard& card, std::string_view called,
              std::size_t maximum, std::vector<int>& set, OfTag of_tag, OfField of_field) {
  const bool ranges = card.find("GENERATE") != nullptr;
  while (text.next_data()) {
    const MeshText& line = text.line();
    if (!ranges) {
      for (std::size_t i = 0; i < line.fields(); ++i) {
        const auto more = of_field(line, i);
        set.insert(set.end(), more.begin(), more.end());
        // Repetitions are removed early, since a name that stands for all entries may occur often.
        if (set.size() > 2 * maximum) remove_repeated(set, maximum);
      }
      continue;
    }
    const Range all = range(line);
    for (std::int64_t tag = all.first; tag <= all.last; tag += all.step) {
      const int number = of_tag(static_cast<int>(tag));
      if (number == MeshIndex::left_out) continue;
      if (number < 0) {
        line.fail(
            0, fmt::format("{} {} does not exist; expected one that is given above", called, tag));
      }
      set.push_back(number);
    }
    // The same for repeated ranges.
    if (set.size() > 2 * maximum) remove_repeated(set, maximum);
  }
  remove_repeated(set, maximum);
}

}  // namespace

void allow_only(const AbaqusText& text, const AbaqusCard& card,
                std::initializer_list<std::string_view> allowed) {
  for (const auto& [name, value] : card.parameters) {
    if (std::ranges::find(allowed, name) != allowed.end()) continue;
    text.line().fail(fmt::format(
        "parameter {} of {} is not understood; expected {}", support::in_quotes(name), card.keyword,
        allowed.size() == 0 ? "none" : fmt::format("{}", fmt::join(allowed, ", "))));
  }
}

const std::string& required(const AbaqusText& text, const AbaqusCard& card, std::string_view name) {
  const std::string* value = card.find(name);
  if (value == nullptr || value->empty()) {
    text.line().fail(
        fmt::format("{} has no {}; expected {}, {}=NAME", card.keyword, name, card.keyword, name));
  }
  return *value;
}

MeshGroup& AbaqusGroups::group(const AbaqusText& text, const std::string& name, MeshPlace at) {
  if (name.empty()) text.line().fail("a set without a name; expected NAME=...");
  const std::string full = full_name(name);
  const auto [entry, is_new] = numbers_.emplace(capitals(full), mesh_.groups.size());
  if (is_new) mesh_.groups.push_back({full, at, {}, {}, {}});
  return mesh_.groups[entry->second];
}

const MeshGroup* AbaqusGroups::find(std::string_view name) const {
  const auto entry = numbers_.find(capitals(full_name(std::string(unquoted(name)))));
  return entry == numbers_.end() ? nullptr : &mesh_.groups[entry->second];
}

std::string AbaqusGroups::full_name(const std::string& name) const {
  const std::string& instance = mesh_.instances[static_cast<std::size_t>(index_.instance())];
  return instance.empty() ? name : instance + "." + name;
}

void AbaqusGroups::begin_instance(const AbaqusText& text, const std::string& name) {
  if (find_instance(name) >= 0) {
    text.line().fail(
        fmt::format("instance {} is given twice; expected once", support::in_quotes(name)));
  }
  mesh_.instances.push_back(name);
  enter(static_cast<int>(mesh_.instances.size()) - 1);
}

int AbaqusGroups::find_instance(std::string_view name) const {
  const auto found = std::ranges::find(mesh_.instances, capitals(name), capitals);
  return found == mesh_.instances.end() ? -1 : static_cast<int>(found - mesh_.instances.begin());
}

int AbaqusGroups::instance_of(const AbaqusText& text, const AbaqusCard& card) const {
  const std::string* name = card.find("INSTANCE");
  if (name == nullptr) return index_.instance();
  const int instance = find_instance(*name);
  if (instance < 1) {
    text.line().fail(fmt::format("instance {} does not exist; expected one that is given above",
                                 support::in_quotes(*name)));
  }
  return instance;
}

std::optional<std::pair<int, int>> AbaqusGroups::tag_of_instance(std::string_view field) const {
  const auto dot = field.rfind('.');
  if (dot == std::string_view::npos || !is_number(field.substr(dot + 1))) return std::nullopt;
  const int instance = find_instance(field.substr(0, dot));
  int tag = 0;
  const auto digits = field.substr(dot + 1);
  const auto fault = std::from_chars(digits.data(), digits.data() + digits.size(), tag).ec;
  if (instance < 1 || fault != std::errc()) return std::nullopt;
  return std::pair(instance, tag);
}

std::vector<int> AbaqusGroups::nodes(const MeshText& line, std::size_t field) const {
  if (field >= line.fields() || is_number(line.field(field))) return {index_.node(line, field)};
  if (const auto tag = tag_of_instance(line.field(field))) {
    const int number = index_.find_node(tag->second, tag->first);
    if (number >= 0) return {number};
  }
  return set_named(line, field, "node", &MeshGroup::nodes);
}

std::vector<int> AbaqusGroups::elements(const MeshText& line, std::size_t field) const {
  const auto present = [](int number) {
    return number < 0 ? std::vector<int>() : std::vector<int>{number};
  };
  if (field >= line.fields() || is_number(line.field(field)))
    return present(index_.element(line, field));
  if (const auto tag = tag_of_instance(line.field(field))) {
    const int number = index_.find_element(tag->second, tag->first);
    if (number != MeshIndex::unknown) return present(number);
  }
  return set_named(line, field, "element", &MeshGroup::elements);
}

// A set whose elements are all left out is empty.
bool AbaqusGroups::is_set(const MeshGroup* group, std::vector<int> MeshGroup::*members) {
  return group != nullptr &&
         (!(group->*members).empty() ||
          (group->nodes.empty() && group->elements.empty() && group->faces.empty()));
}

const std::vector<int>& AbaqusGroups::set_named(const MeshText& line, std::size_t field,
                                                std::string_view kind,
                                                std::vector<int> MeshGroup::*members) const {
  const MeshGroup* set = find(line.field(field));
  if (!is_set(set, members)) {
    line.fail(field, fmt::format("{} set {} does not exist; expected one that is given above", kind,
                                 support::in_quotes(line.field(field))));
  }
  return set->*members;
}

const MeshGroup& AbaqusGroups::set_of(const AbaqusText& text, const std::string& name,
                                      std::string_view kind,
                                      std::vector<int> MeshGroup::*members) const {
  const MeshGroup* set = find(name);
  if (!is_set(set, members)) {
    text.line().fail(fmt::format("{} set {} does not exist; expected one that is given above", kind,
                                 support::in_quotes(name)));
  }
  return *set;
}

std::string AbaqusGroups::surface_name(const MeshText& line, std::size_t field) const {
  if (field >= line.fields()) line.fail(field, "the line ends; expected the name of a surface");
  const auto name = unquoted(line.field(field));
  if (const MeshGroup* group = find(name)) return group->name;
  if (!analytical_.contains(capitals(name))) {
    line.fail(field, fmt::format("surface {} does not exist; expected one that is given above",
                                 support::in_quotes(name)));
  }
  return {};
}

const MeshGroup& AbaqusGroups::node_set(const AbaqusText& text, const std::string& name) const {
  return set_of(text, name, "node", &MeshGroup::nodes);
}

const MeshGroup& AbaqusGroups::element_set(const AbaqusText& text, const std::string& name) const {
  return set_of(text, name, "element", &MeshGroup::elements);
}

template <class Read>
void AbaqusGroups::read_group(AbaqusText& text, const AbaqusCard& card, std::string_view keyword,
                              std::vector<int> MeshGroup::*members, Read read) {
  allow_only(text, card, {keyword, "GENERATE", "UNSORTED", "INTERNAL", "INSTANCE"});
  std::vector<int> set = group(text, required(text, card, keyword), card.at).*members;
  const int before = index_.instance();
  enter(instance_of(text, card));
  read(set);
  enter(before);
  MeshGroup& all = group(text, *card.find(keyword), card.at);
  all.*members = std::move(set);
  refuse_other_members(text, *card.find(keyword), all, members);
}

void AbaqusGroups::read_node_set(AbaqusText& text, const AbaqusCard& card) {
  read_group(text, card, "NSET", &MeshGroup::nodes, [&](std::vector<int>& set) {
    read_set(
        text, card, "node", mesh_.nodes.size(), set, [&](int tag) { return index_.find_node(tag); },
        [&](const MeshText& line, std::size_t field) { return nodes(line, field); });
  });
}

void AbaqusGroups::read_element_set(AbaqusText& text, const AbaqusCard& card) {
  read_group(text, card, "ELSET", &MeshGroup::elements, [&](std::vector<int>& set) {
    read_set(
        text, card, "element", mesh_.elements.size(), set,
        [&](int tag) { return index_.find_element(tag); },
        [&](const MeshText& line, std::size_t field) { return elements(line, field); });
  });
}

}  // namespace kusabi::problems
