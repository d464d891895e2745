// Warnings of loads and of clearances without effect.
#include "run/wedged/ignored_loads.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "problems/structure/model/load_cases.hpp"

namespace kusabi::run {
namespace {

// Clearances concern states under load only.
void add_clearances(const problems::Structure& structure, std::string_view command,
                    std::vector<std::string>& lines) {
  const auto& contact = structure.contact;
  const auto apart = [](const auto& candidate) { return candidate.clearance != 0; };
  const auto first = std::ranges::find_if(contact, apart);
  if (first == contact.end()) return;
  const auto count = static_cast<std::uint64_t>(std::ranges::count_if(contact, apart));
  const auto message = fmt::format(
      "kusabi {} ignores the clearance or interference of {}: the gaps of a wedged configuration "
      "are zero; kusabi hold uses them",
      command, answer::counted(count, "contact candidate"));
  const auto position =
      problems::position_of(structure.sources.contact, static_cast<int>(first - contact.begin()));
  lines.emplace_back(problems::structure_error(structure, position, message).what());
}

}  // namespace

std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command) {
  std::vector<std::string> lines;
  const auto& sources = structure.sources;
  const auto uncertain = structure.uncertain ? structure.uncertain->size() : 0;
  // `patterns` lists how much of a reference load each pattern holds, without load cases.
  const bool reference = command == "patterns" && problems::load_cases(structure).empty();
  const auto is_ignored = [&](const problems::Load& load) {
    return !reference || load.kind == problems::Load::Kind::dead;
  };
  const auto first = std::ranges::find_if(structure.loads, is_ignored);
  const bool loads = first != structure.loads.end();
  if (loads || uncertain != 0) {
    const auto position =
        problems::position_of(loads ? sources.loads : sources.uncertain,
                              loads ? static_cast<int>(first - structure.loads.begin()) : 0);
    const auto count =
        static_cast<std::uint64_t>(std::ranges::count_if(structure.loads, is_ignored));
    const auto message = fmt::format(
        "kusabi {} ignores {} of the file: wedged configurations are without load; kusabi hold "
        "searches states under load, kusabi limit the limit load of a truss",
        command,
        loads ? answer::counted(count, "load") : answer::counted(uncertain, "uncertain load"));
    lines.emplace_back(problems::structure_error(structure, position, message).what());
  }
  if (structure.imposed_forces.size() > 0) {
    lines.emplace_back(
        problems::structure_error(
            structure, {},
            fmt::format("kusabi {} ignores temperature and displaced supports: wedged "
                        "configurations are without them; kusabi hold uses them",
                        command))
            .what());
  }
  add_clearances(structure, command, lines);
  return lines;
}

std::vector<std::string> ignored_uncertainty(const problems::Structure& structure,
                                             std::string_view command) {
  if (!structure.uncertain || structure.uncertain->empty()) return {};
  const auto message =
      fmt::format("kusabi {} ignores {} without a half-width: the loads are those of the file",
                  command, answer::counted(structure.uncertain->size(), "uncertain load"));
  const auto position = problems::position_of(structure.sources.uncertain, 0);
  return {problems::structure_error(structure, position, message).what()};
}

}  // namespace kusabi::run
