// Stages of the preparation.
#include "run/wedged/contact_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "answer/values.hpp"
#include "engine/collectives.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/output/values.hpp"
#include "run/session/kept_state.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {

ContactProblem contact_problem(CommandRun& run, const ProblemInput& input,
                               std::optional<double> friction) {
  auto [structure, facets] = input.structure_and_facets(run);
  warn_all(run.session(), ignored_loads(structure, run.name()));
  if (friction) warn_of_facets(run, input, facets, *friction);
  auto problem = agreed_problem(run, structure);
  return {std::move(structure), std::move(facets), std::move(problem)};
}

problems::WedgedProblem agreed_problem(CommandRun& run,
                                       const problems::CheckedStructure& structure) {
  auto problem = run.within_limits(
      [&](const auto& work) { return problems::wedged_problem(structure, work); });
  make_equal_on_all_ranks(run.session(), problem);
  return problem;
}

void warn_of_facets(CommandRun& run, const ProblemInput& input,
                    const std::vector<problems::FacetWarning>& facets, double friction) {
  warn_all(run.session(), warning_lines(facets, friction, input.file));
}

void keep_state(CommandRun& run, const CheckpointChoice& choice,
                const problems::WedgedProblem& problem) {
  run.keep_state(choice, {{"the problem", hexadecimal(problem.provenance.fingerprint)}});
}

std::uint64_t fingerprint_of_loads(const problems::Structure& structure) {
  support::Fingerprint fingerprint;
  for (const auto& load : structure.loads) {
    fingerprint.add(load.kind == problems::Load::Kind::dead ? 0.0 : 1.0);
    fingerprint.add(static_cast<double>(load.node));
    if (!load.load_case.empty()) fingerprint.add(std::string_view(load.load_case));
    for (const double component : load.force) fingerprint.add(component);
  }
  for (const double force : structure.imposed_forces.reshaped()) fingerprint.add(force);
  for (const auto& point : structure.contact) fingerprint.add(point.clearance);
  return fingerprint.value();
}

namespace {

template <class Matrix>
std::span<const double> doubles_of(const Matrix& matrix) {
  const auto each = sizeof(typename Matrix::Scalar) / sizeof(double);
  return {reinterpret_cast<const double*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * each};
}

// Stiffness and compliance as a list of numbers, after their number of rows.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(const problems::Compliance& compliance) {
    add(compliance.stiffness);
    add(compliance.matrix);
    add(compliance.precise);
    list_.push_back(compliance.error);
    list_.push_back(compliance.precise_error);
  }

  [[nodiscard]] std::uint64_t fingerprint() const {
    support::Fingerprint result;
    for (const double number : list_) result.add(number);
    return result.value();
  }

  void copy_to(problems::Compliance& compliance) const {
    auto next = list_.begin();
    copy(next, compliance.stiffness);
    copy(next, compliance.matrix);
    copy(next, compliance.precise);
    compliance.error = *next++;
    compliance.precise_error = *next;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned) {
    archive& list_;
  }

 private:
  using Place = std::vector<double>::const_iterator;

  template <class Matrix>
  void add(const Matrix& matrix) {
    const auto numbers = doubles_of(matrix);
    list_.push_back(static_cast<double>(matrix.rows()));
    list_.insert(list_.end(), numbers.begin(), numbers.end());
  }

  template <class Matrix>
  static void copy(Place& next, Matrix& matrix) {
    const auto rows = static_cast<Eigen::Index>(*next++);
    matrix.resize(rows, rows);
    const auto count = static_cast<std::ptrdiff_t>(doubles_of(matrix).size());
    std::copy_n(next, count, reinterpret_cast<double*>(matrix.data()));
    next += count;
  }

  std::vector<double> list_;
};

}  // namespace

void make_equal_on_all_ranks(Session& session, problems::WedgedProblem& problem) {
  auto& transport = session.transport();
  engine::require_equal_on_all_ranks(transport, problem.provenance.fingerprint);
  if (transport.size() == 1) return;
  const Numbers own(problem.compliance);
  const auto mark = own.fingerprint();
  const auto first = engine::from_first_rank(transport, [&] { return mark; });
  const auto all = engine::all_reduce(transport, {.ranks = 1, .found = first == mark ? 0U : 1U});
  if (all.found == 0) return;
  engine::from_first_rank(transport, [&] { return own; }).copy_to(problem.compliance);
}

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
