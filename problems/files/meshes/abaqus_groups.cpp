// Sets of nodes and elements, and faces of elements.
#include "problems/files/meshes/abaqus_groups.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/structure/geometry/element_faces.hpp"
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

/// Maximum number of faces of an element.
constexpr std::size_t most_faces = 6;

bool is_number(std::string_view field) {
  return !field.empty() && (std::isdigit(static_cast<unsigned char>(field.front())) != 0 ||
                            field.front() == '-' || field.front() == '+');
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

/// Adds the content of the data lines of a set: each line is a range or a list.
/// @param of_tag conversion of a tag to a number, -1 if there is none  @param of_field of a field
template <class OfTag, class OfField>
void read_set(AbaqusText& text, const AbaqusCard& card, std::string_view called, std::size_t most,
              std::vector<int>& set, OfTag of_tag, OfField of_field) {
  const bool ranges = card.find("GENERATE") != nullptr;
  while (text.next_data()) {
    const MeshText& line = text.line();
    if (!ranges) {
      for (std::size_t i = 0; i < line.fields(); ++i) {
        const auto more = of_field(line, i);
        set.insert(set.end(), more.begin(), more.end());
        // A name may stand for all entries and occur often in a file.
        if (set.size() > 2 * most) remove_repeated(set, most);
      }
      continue;
    }
    const Range all = range(line);
    for (std::int64_t tag = all.first; tag <= all.last; tag += all.step) {
      const int number = of_tag(static_cast<int>(tag));
      if (number < 0) {
        line.fail(
            0, fmt::format("{} {} does not exist; expected one that is given above", called, tag));
      }
      set.push_back(number);
    }
    // A line may have many names, too.
    if (set.size() > 2 * most) remove_repeated(set, most);
  }
  remove_repeated(set, most);
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
  const auto [entry, is_new] = numbers_.emplace(capitals(name), mesh_.groups.size());
  if (is_new) mesh_.groups.push_back({name, at, {}, {}, {}});
  return mesh_.groups[entry->second];
}

const MeshGroup* AbaqusGroups::find(std::string_view name) const {
  const auto entry = numbers_.find(capitals(name));
  return entry == numbers_.end() ? nullptr : &mesh_.groups[entry->second];
}

std::vector<int> AbaqusGroups::nodes(const MeshText& line, std::size_t field) const {
  if (field >= line.fields() || is_number(line.field(field))) return {index_.node(line, field)};
  return set_named(line, field, "node", &MeshGroup::nodes);
}

std::vector<int> AbaqusGroups::elements(const MeshText& line, std::size_t field) const {
  if (field >= line.fields() || is_number(line.field(field))) return {index_.element(line, field)};
  return set_named(line, field, "element", &MeshGroup::elements);
}

const std::vector<int>& AbaqusGroups::set_named(const MeshText& line, std::size_t field,
                                                std::string_view kind,
                                                std::vector<int> MeshGroup::*members) const {
  const MeshGroup* set = find(line.field(field));
  if (set == nullptr || (set->*members).empty()) {
    line.fail(field, fmt::format("{} set {} does not exist; expected one that is given above", kind,
                                 support::in_quotes(line.field(field))));
  }
  return set->*members;
}

const std::vector<int>& AbaqusGroups::element_set(const AbaqusText& text,
                                                  const std::string& name) const {
  const MeshGroup* set = find(name);
  if (set == nullptr || set->elements.empty()) {
    text.line().fail(fmt::format("element set {} does not exist; expected one that is given above",
                                 support::in_quotes(name)));
  }
  return set->elements;
}

void AbaqusGroups::read_node_set(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"NSET", "GENERATE", "UNSORTED"});
  std::vector<int> set = group(text, required(text, card, "NSET"), card.at).nodes;
  read_set(
      text, card, "node", mesh_.nodes.size(), set, [&](int tag) { return index_.find_node(tag); },
      [&](const MeshText& line, std::size_t field) { return nodes(line, field); });
  group(text, *card.find("NSET"), card.at).nodes = std::move(set);
}

void AbaqusGroups::read_element_set(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"ELSET", "GENERATE", "UNSORTED"});
  std::vector<int> set = group(text, required(text, card, "ELSET"), card.at).elements;
  read_set(
      text, card, "element", mesh_.elements.size(), set,
      [&](int tag) { return index_.find_element(tag); },
      [&](const MeshText& line, std::size_t field) { return elements(line, field); });
  group(text, *card.find("ELSET"), card.at).elements = std::move(set);
}

void AbaqusGroups::read_surface(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"NAME", "TYPE"});
  MeshGroup& surface = group(text, required(text, card, "NAME"), card.at);
  const std::string* type = card.find("TYPE");
  const std::string kind = type == nullptr ? "ELEMENT" : capitals(*type);
  if (kind != "ELEMENT" && kind != "NODE") {
    text.line().fail(
        fmt::format("a surface of type {}; expected ELEMENT or NODE", support::in_quotes(kind)));
  }
  while (text.next_data()) {
    if (kind == "ELEMENT") {
      read_face(text, surface);
    } else {
      const auto more = nodes(text.line(), 0);
      surface.nodes.insert(surface.nodes.end(), more.begin(), more.end());
      if (surface.nodes.size() > 2 * mesh_.nodes.size()) {
        remove_repeated(surface.nodes, mesh_.nodes.size());
      }
    }
  }
  remove_repeated(surface.nodes, mesh_.nodes.size());
}

void AbaqusGroups::read_face(const AbaqusText& text, MeshGroup& surface) {
  const MeshText& line = text.line();
  const auto set = elements(line, 0);
  const std::string label = line.fields() > 1 ? capitals(line.field(1)) : std::string();
  const int face = label.size() == 2 && label[0] == 'S' ? label[1] - '1' : -1;
  for (const int number : set) {
    const MeshElement& element = mesh_.elements[static_cast<std::size_t>(number)];
    const int faces = mesh_dimension(element.shape) < 2
                          ? 0
                          : static_cast<int>(element_faces(element_shape(element.shape)).size());
    if (face < 0 || face >= faces) {
      line.fail(1, fmt::format("face {} of element {}, {}; expected one of S1 to S{}",
                               support::in_quotes(label), element.tag, mesh_called(element.shape),
                               faces));
    }
    surface.faces.push_back({number, face});
    if (surface.faces.size() > most_faces * mesh_.elements.size()) {
      line.fail("a surface of more faces than the mesh has; expected each once");
    }
  }
}

}  // namespace kusabi::problems
