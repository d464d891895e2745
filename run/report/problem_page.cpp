// The undeformed structure with candidates and loads, its summary and its warnings.
#include "run/report/problem_page.hpp"

#include <fmt/format.h>

#include "answer/values.hpp"
#include "pictures/html/markup.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/report/page/page_parts.hpp"
#include "run/report/page/turning_script.hpp"
#include "run/report/page/turning_view.hpp"
#include "run/report/problem_facts.hpp"
#include "run/results/drawn_structure.hpp"

namespace kusabi::run {
namespace {

// Dead and reference loads, as in the answers of limit analysis.
void add_loads(const ResultReader& problem, pictures::Scene& scene) {
  using Kind = pictures::DrawnLoad::Kind;
  const auto& structure = problem.at(problem.at(problem.all(), "problem"), "structure");
  for (const auto& [key, kind] :
       {std::pair{"dead_loads", Kind::dead}, std::pair{"reference_loads", Kind::reference}}) {
    const auto* const loads = ResultReader::find(structure, key);
    if (loads == nullptr) continue;
    for (const auto& load : *loads) {
      scene.loads.push_back({kind,
                             problem.index(problem.at(load, "node"),
                                           static_cast<std::size_t>(scene.positions.cols())),
                             problem.vector(problem.at(load, "force"), scene.dimension)});
    }
  }
}

}  // namespace

std::string problem_page(const ResultReader& problem, const std::string& summary,
                         const std::vector<std::string>& warnings) {
  const auto& header = problem.at(problem.all(), "problem");
  const auto& units = problem.at(header, "units");
  auto scene = drawn_structure(problem).scene;
  add_loads(problem, scene);
  const auto name = problem.text(header, "name");
  pictures::Markup page;
  begin_page(page, name + " · kusabi show");
  page.open("header").element("h1", name);
  add_list(page, "warnings", warnings);
  page.close().open("main").open("section", {{"id", "leading"}, {"class", "beside"}});
  open_figure(page, turning_data(scene));
  page.verbatim(
      inline_svg({"structure", "The structure",
                  fmt::format("{}, {}", answer::counted(scene.positions.cols(), "node"),
                              answer::counted(scene.candidates.size(), "contact candidate")),
                  true},
                 scene));
  page.close().open("div");
  page.element("pre", summary);
  page.verbatim(
      inline_legend({"legend", "Legend", "Legend of the picture."},
                    legend(scene, {problem.text(units, "length"), problem.text(units, "force")})));
  page.close().close().open("section", {{"id", "facts"}}).element("h2", "Problem");
  add_problem(page, problem);
  page.close().close();
  page.open("script").verbatim(turning_script).close();
  page.close().close();
  return page.text();
}

}  // namespace kusabi::run
