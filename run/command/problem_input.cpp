// Problem file, from its name to its structure.
#include "run/command/problem_input.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "run/command/command_run.hpp"

namespace kusabi::run {

void ProblemInput::read(CommandRun& run) {
  text = run.session().from_first_rank([&] { return problems::problem_text(file); });
  std::vector<std::string> named;
  for (const auto& [place, bytes] : text.meshes)
    named.push_back((std::filesystem::path(file).parent_path() / place).string());
  run.keep(named);
}

problems::CheckedStructure ProblemInput::structure(CommandRun& run) const {
  return structure_and_facets(run).structure;
}

problems::StructureAndFacets ProblemInput::structure_and_facets(CommandRun& run) const {
  auto parsed = problems::read_structure_and_facets(text, file);
  warn_all(run.session(), parsed.structure->warnings);
  return parsed;
}

}  // namespace kusabi::run
