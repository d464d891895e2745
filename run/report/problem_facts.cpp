// From the structure of a result file; older files have no materials.
#include "run/report/problem_facts.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "run/report/facts.hpp"

namespace kusabi::run {
namespace {

class ProblemFacts {
 public:
  explicit ProblemFacts(const ResultReader& reader)
      : reader_(reader),
        problem_(reader.at(reader.all(), "problem")),
        structure_(reader.at(problem_, "structure")),
        length_(reader.text(reader.at(problem_, "units"), "length")),
        force_(reader.text(reader.at(problem_, "units"), "force")) {}

  void add(pictures::Markup& page) const {
    begin_facts(page, "The problem");
    add_fact(page, "name", reader_.text(problem_, "name"));
    add_fact(page, "structure",
             fmt::format("{}, {}", reader_.number(problem_, "d") == 2 ? "in the plane" : "in space",
                         answer::counted(size("node_names"), "node")));
    add_fact(page, "mesh", mesh());
    add_fact(page, "members", size("members") > 0 ? std::to_string(size("members")) : "");
    add_fact(page, "material", material());
    add_fact(page, "supports", supports());
    add_fact(page, "unconstrained", unconstrained());
    add_fact(page, "contact candidates", candidates());
    add_fact(page, "friction coefficient", friction());
    add_fact(page, "loads", loads());
    add_fact(page, "units", length_ + " and " + force_);
    end_table(page);
  }

 private:
  [[nodiscard]] const ResultJson* find(const char* key) const {
    return ResultReader::find(structure_, key);
  }
  [[nodiscard]] std::size_t size(const char* key) const {
    const auto* const list = find(key);
    return list == nullptr ? 0 : list->size();
  }
  [[nodiscard]] static std::string joined_parts(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  [[nodiscard]] std::string mesh() const {
    std::vector<std::string> parts;
    for (const char* const key : {"elements", "outlines"}) {
      const auto* const groups = find(key);
      if (groups == nullptr) continue;
      for (const auto& group : *groups) {
        parts.push_back(fmt::format("{} × {}{}", reader_.list(group, "nodes").size(),
                                    reader_.text(group, "shape"),
                                    *key == 'o' ? " with a stiffness from a file" : ""));
      }
    }
    return joined_parts(parts);
  }

  [[nodiscard]] std::string material() const {
    std::vector<std::string> parts;
    const auto* const materials = find("materials");
    if (materials != nullptr) {
      for (const auto& each : *materials) {
        auto text = fmt::format("E = {:.6g} {}/{}², ν = {:.6g}", reader_.number(each, "E"), force_,
                                length_, reader_.number(each, "nu"));
        if (ResultReader::find(each, "thickness") != nullptr) {
          text += fmt::format(", plane {}, thickness {:.6g} {}", reader_.text(each, "plane"),
                              reader_.number(each, "thickness"), length_);
        }
        if (materials->size() > 1)
          text += fmt::format(
              " ({})", answer::counted(static_cast<std::uint64_t>(reader_.number(each, "elements")),
                                       "element"));
        parts.push_back(std::move(text));
      }
    }
    add_range(parts, "axial_stiffnesses", "EA");
    return fmt::format("{}", fmt::join(parts, "; "));
  }

  // "EA = 10 kN", or the range over the members.
  void add_range(std::vector<std::string>& parts, const char* key, const char* name) const {
    const auto* const list = find(key);
    if (list == nullptr || list->empty()) return;
    std::vector<double> values;
    for (const auto& each : *list) {
      if (!each.is_number()) return;
      values.push_back(each.get<double>());
    }
    const auto [minimum, maximum] = std::ranges::minmax(values);
    parts.push_back(minimum == maximum
                        ? fmt::format("{} = {:.6g} {}", name, minimum, force_)
                        : fmt::format("{} = {:.6g} to {:.6g} {}", name, minimum, maximum, force_));
  }

  [[nodiscard]] std::string supports() const {
    std::vector<std::string> parts;
    if (const auto* const fixed = find("fixed")) {
      for (const auto& [axis, nodes] : fixed->items())
        parts.push_back(fmt::format("{} along {}", answer::counted(nodes.size(), "node"), axis));
    }
    const auto add = [&](const char* key, const char* thing) {
      if (size(key) > 0) parts.push_back(answer::counted(size(key), thing));
    };
    add("inclined_supports", "inclined support");
    add("springs", "spring");
    add("ties", "multi-point constraint");
    return parts.empty() ? "none" : joined_parts(parts);
  }

  [[nodiscard]] std::string unconstrained() const {
    std::vector<std::string> parts;
    const auto* const bodies = ResultReader::find(problem_, "rigid_motions");
    if (bodies == nullptr) return {};
    for (const auto& each : *bodies) {
      parts.push_back(fmt::format("the body of {} ({}) {}", reader_.text(each, "node"),
                                  answer::counted(reader_.count(each, "nodes"), "node"),
                                  reader_.text(each, "motions")));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
  }

  [[nodiscard]] std::string candidates() const {
    const auto* const contact = ResultReader::find(problem_, "contact");
    if (contact == nullptr) return {};
    std::size_t pairs = 0;
    if (const auto* const against = find("against")) {
      pairs = static_cast<std::size_t>(
          std::ranges::count_if(*against, [](const auto& each) { return !each.empty(); }));
    }
    return pairs == 0 ? std::to_string(contact->size())
                      : fmt::format("{}, {} of them against another body", contact->size(), pairs);
  }

  [[nodiscard]] std::string friction() const {
    const auto& result = reader_.at(reader_.all(), "result");
    return ResultReader::find(result, "friction") == nullptr
               ? std::string()
               : fmt::format("{:.10g}{}", reader_.number(result, "friction"),
                             has_own_friction(reader_) ? " times that of the file" : "");
  }

  [[nodiscard]] std::string loads() const {
    std::vector<std::string> parts;
    const auto add = [&](std::size_t count, const char* thing) {
      if (count > 0) parts.push_back(answer::counted(count, thing));
    };
    add(size("dead_loads"), "dead load");
    add(size("reference_loads"), "reference load");
    if (const auto* const uncertain = ResultReader::find(problem_, "uncertain_loads"))
      add(uncertain->size(), "uncertain load");
    return joined_parts(parts);
  }

  const ResultReader& reader_;
  const ResultJson& problem_;
  const ResultJson& structure_;
  std::string length_, force_;
};

}  // namespace

void add_problem(pictures::Markup& page, const ResultReader& reader) {
  ProblemFacts(reader).add(page);
}

}  // namespace kusabi::run
