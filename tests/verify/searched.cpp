#include "searched.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/files/structure_file.hpp"
#include "run/evidence/certificate_file.hpp"
#include "support/one_line.hpp"
#include "support/sha1.hpp"
#include "verify/structure/condensation.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/cover.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

std::string sealed(const std::string& text) {
  const auto body = text.substr(0, text.rfind("digest "));
  return fmt::format("{}digest {}\n", body, support::hexadecimal(support::sha1(body)));
}

std::string misspelt(std::string text, std::size_t begin, std::size_t size,
                     std::mt19937_64& generator) {
  constexpr std::string_view likely = "0123456789abcdef-+xp \n";
  for (auto changes = 1 + generator() % 3; changes > 0; --changes) {
    const char letter = likely[generator() % likely.size()];
    text[begin + generator() % size] = letter;
  }
  return sealed(text);
}

std::vector<std::string> Draft::before_nodes() const {
  auto lines = header;
  const auto blocks =
      std::ranges::count_if(header, [](const auto& line) { return line.starts_with("block "); });
  lines.emplace_back("loads 0\n");
  lines.push_back(fmt::format("theorems {}\n", blocks));
  for (std::ptrdiff_t block = 1; block <= blocks; ++block)
    lines.push_back(fmt::format("none {} 0\n", block));
  lines.push_back(fmt::format("bounds {}\n", bounds.size()));
  lines.insert(lines.end(), bounds.begin(), bounds.end());
  lines.emplace_back("evidence\n");
  return lines;
}

std::size_t Draft::lines_before_nodes() const {
  return before_nodes().size();
}

std::string Draft::text() const {
  std::string body;
  for (const auto& line : before_nodes()) body += line;
  for (const auto& line : nodes) body += line;
  return sealed(body + fmt::format("end {}\n", nodes.size()));
}

problems::WedgedProblem example(const std::string& name) {
  return problems::wedged_problem(checked(example_structure(name)));
}

problems::Structure example_structure(const std::string& name) {
  return problems::load_structure(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

namespace {

template <class Numbers>
std::string listed(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format(" {:a}", number);
  return text;
}

std::string node_line(const wedged::Evidence& evidence) {
  using Kind = wedged::Evidence::Kind;
  const auto* const kind = evidence.kind == Kind::infeasible ? "infeasible"
                           : evidence.kind == Kind::feasible ? "wedged"
                                                             : "marginal";
  return fmt::format("{} 1 {} {}{}\n", kind, hexadecimal(evidence.node.contact),
                     hexadecimal(evidence.node.separated), listed(evidence.numbers));
}

}  // namespace

void expect_same_stiffness(const problems::Structure& structure) {
  const auto problem = problems::wedged_problem(checked(structure));
  const auto result = condensed_stiffness(evidence::verified_structure(structure));
  ASSERT_TRUE(std::holds_alternative<EnclosedMatrix>(result)) << std::get<std::string>(result);
  const auto& matrix = std::get<EnclosedMatrix>(result);
  const double size = problem.compliance.stiffness.norm();
  ASSERT_EQ(matrix.middle.size, static_cast<std::size_t>(problem.compliance.stiffness.rows()));
  for (Eigen::Index i = 0; i < problem.compliance.stiffness.size(); ++i) {
    EXPECT_NEAR(matrix.middle.entries[static_cast<std::size_t>(i)].nearest(),
                problem.compliance.stiffness(i), 1e-11 * size);
  }
  EXPECT_LT(matrix.radius.nearest(), 1e-30 * size);
}

std::string written(const problems::WedgedProblem& problem, double mu) {
  auto friction = problem.friction;
  for (double& factor : friction) factor *= mu;
  std::string text = run::certificate_header(problem, friction, run::list_theorems(problem));
  std::size_t count = 0;
  wedged::SignPatternTree tree(problem, friction, {.tolerances = {}, .thorough = true});
  tree.report_to([&](const auto& evidence) {
    text += run::certificate_line(evidence);
    ++count;
  });
  engine::search(tree);
  return sealed(text + fmt::format("end {}\n", count));
}

Draft searched(const problems::WedgedProblem& problem, double friction) {
  const auto m = problem.contact_names.size();
  const std::vector<double> everywhere(m, friction);
  Draft draft;
  draft.header = {"kusabi certificate 5 contact\n",
                  fmt::format("dimension {}\n", problem.dimension),
                  fmt::format("candidates {}\n", m)};
  for (const auto& name : problem.contact_names) {
    draft.header.push_back(fmt::format("name {}\n", support::on_one_line(name)));
  }
  draft.header.push_back("friction" + listed(everywhere) + "\n");
  draft.header.emplace_back("blocks 1\n");
  const auto everything = IndexSet::below(static_cast<int>(m));
  draft.header.push_back(fmt::format("block {}\n", hexadecimal(everything)));
  draft.header.emplace_back("stiffness\n");
  for (Eigen::Index i = 0; i < problem.compliance.stiffness.rows(); ++i) {
    const Eigen::VectorXd row = problem.compliance.stiffness.row(i).head(i + 1);
    draft.header.push_back(listed(row).substr(1) + "\n");
  }
  draft.header.emplace_back("motions 0\n");
  auto whole = problem;
  whole.blocks.clear();
  wedged::SignPatternTree tree(whole, everywhere, {.tolerances = {}, .thorough = true});
  tree.report_to([&](const auto& evidence) { draft.nodes.push_back(node_line(evidence)); });
  engine::search(tree);
  return draft;
}

Draft in_blocks(const Draft& first, const Draft& second) {
  const auto candidates = [](const Draft& draft) {
    return static_cast<std::size_t>(std::ranges::count_if(
        draft.header, [](const auto& line) { return line.starts_with("name"); }));
  };
  const auto after = [](const Draft& draft, const std::string& start) {
    return std::ranges::find_if(draft.header,
                                [&](const auto& line) { return line.starts_with(start); });
  };
  const auto m = candidates(first);
  const auto n = candidates(second);
  Draft both;
  both.header = {"kusabi certificate 5 contact\n", first.header[1],
                 fmt::format("candidates {}\n", m + n)};
  for (std::size_t i = 0; i < m; ++i)
    both.header.push_back("name a-" + first.header[3 + i].substr(5));
  for (std::size_t i = 0; i < n; ++i)
    both.header.push_back("name b-" + second.header[3 + i].substr(5));
  const auto one = *after(first, "friction");
  both.header.push_back(one.substr(0, one.size() - 1) + after(second, "friction")->substr(8));
  both.header.push_back(n == 0 ? "blocks 1\n" : "blocks 2\n");
  const auto all_of_first = IndexSet::below(static_cast<int>(m));
  const auto all = IndexSet::below(static_cast<int>(m + n));
  both.header.push_back(fmt::format("block {}\n", hexadecimal(all_of_first)));
  if (n > 0) both.header.push_back(fmt::format("block {}\n", hexadecimal(all - all_of_first)));
  both.header.emplace_back("stiffness\n");
  const auto end_of_rows = std::string("motions 0\n");
  std::size_t rows = 0;
  for (auto line = after(first, "stiffness") + 1; *line != end_of_rows; ++line, ++rows) {
    both.header.push_back(*line);
  }
  std::string zeros;
  for (std::size_t i = 0; i < rows; ++i) zeros += "0x0p+0 ";
  for (auto line = after(second, "stiffness") + 1; n > 0 && *line != end_of_rows; ++line) {
    both.header.push_back(zeros + *line);
  }
  both.header.push_back(end_of_rows);
  const auto add = [&](const Draft& draft, int block, int shift) {
    for (const auto& line : draft.nodes) {
      const auto theorem = line.find(' ') + 1;
      const auto sets = line.find(' ', theorem) + 1;
      const auto second_set = line.find(' ', sets) + 1;
      const auto rest = line.find_first_of(" \n", second_set);
      const auto moved = [&](std::size_t from, std::size_t to) {
        IndexSet set;
        for (const int i : IndexSet(std::stoull(line.substr(from, to - from), nullptr, 16)))
          set.insert(i + shift);
        return hexadecimal(set);
      };
      both.nodes.push_back(fmt::format("{}{} {} {}{}", line.substr(0, theorem), block,
                                       moved(sets, second_set - 1), moved(second_set, rest),
                                       line.substr(rest)));
    }
  };
  add(first, 1, 0);
  add(second, 2, static_cast<int>(m));
  return both;
}

Verdict verdict(const std::string& text) {
  return verdict(text, nullptr);
}

Verdict verdict(const std::string& text, const Structure* structure) {
  const auto certificate = read_certificate(text, "cert");
  Verdict result;
  std::optional<ConsistentStructure> agreed;
  if (structure != nullptr) {
    auto found = consistency(certificate, *structure);
    if (const auto* why = std::get_if<std::string>(&found)) {
      result.refusals.push_back(*why);
      return result;
    }
    agreed = std::move(std::get<ConsistentStructure>(found));
  }
  auto proof = agreed ? Proof(certificate, agreed->stiffness, agreed->motions) : Proof(certificate);
  if (!proof.min_eigenvalue()) {
    result.refusals.emplace_back("K");
    return result;
  }
  for (const auto& bound : certificate.bounds) {
    if (auto why = proof.add_bound(bound)) {
      result.refusals.push_back(*why);
    } else {
      ++result.bounds;
    }
  }
  for (const auto& node : certificate.nodes) {
    const auto proof_result = proof.proof_result(node);
    if (proof_result.except_large_displacements) ++result.except_large_displacements;
    if (proof_result.unloaded) ++result.unloaded;
    if (proof_result.refusal) {
      result.refusals.push_back(*proof_result.refusal);
    } else {
      ++(node.claim == Claim::none ? result.marginal : result.infeasible);
    }
  }
  for (const auto& state : certificate.states) {
    if (auto why = proof.refusal(state))
      result.refusals.push_back(*why);
    else
      result.feasible.insert(state.contact);
  }
  for (std::size_t theorem = 0; theorem < certificate.theorems.size(); ++theorem) {
    if (auto flaw = flaw_of_cover(certificate, theorem)) result.refusals.push_back(*flaw);
  }
  return result;
}

}  // namespace kusabi::verify
