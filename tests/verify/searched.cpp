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

std::string Draft::text() const {
  std::string body;
  for (const auto& line : header) body += line;
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
  const auto* const kind = evidence.kind == Kind::infeasible ? "dead"
                           : evidence.kind == Kind::feasible ? "alive"
                                                             : "marginal";
  return fmt::format("{} {} {}{}\n", kind, hexadecimal(evidence.node.contact),
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
  std::string text = run::certificate_header(problem, friction);
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
  draft.header = {"kusabi certificate 1\n", fmt::format("dimension {}\n", problem.dimension),
                  fmt::format("candidates {}\n", m)};
  for (const auto& name : problem.contact_names) {
    draft.header.push_back(fmt::format("name {}\n", on_one_line(name)));
  }
  draft.header.push_back("friction" + listed(everywhere) + "\n");
  draft.header.emplace_back("stiffness\n");
  for (Eigen::Index i = 0; i < problem.compliance.stiffness.rows(); ++i) {
    const Eigen::VectorXd row = problem.compliance.stiffness.row(i).head(i + 1);
    draft.header.push_back(listed(row).substr(1) + "\n");
  }
  draft.header.emplace_back("nodes\n");
  // Version 1 has no blocks.
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
  both.header = {"kusabi certificate 2\n", first.header[1], fmt::format("candidates {}\n", m + n)};
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
  const auto nodes_line = std::string("nodes\n");
  std::size_t rows = 0;
  for (auto line = after(first, "stiffness") + 1; *line != nodes_line; ++line, ++rows) {
    both.header.push_back(*line);
  }
  std::string zeros;
  for (std::size_t i = 0; i < rows; ++i) zeros += "0x0p+0 ";
  for (auto line = after(second, "stiffness") + 1; n > 0 && *line != nodes_line; ++line) {
    both.header.push_back(zeros + *line);
  }
  both.header.push_back(nodes_line);
  const auto add = [&](const Draft& draft, int block, int shift) {
    for (const auto& line : draft.nodes) {
      const auto sets = line.find(' ') + 1;
      const auto second_set = line.find(' ', sets) + 1;
      const auto rest = line.find_first_of(" \n", second_set);
      const auto moved = [&](std::size_t from, std::size_t to) {
        IndexSet set;
        for (const int i : IndexSet(std::stoull(line.substr(from, to - from), nullptr, 16)))
          set.insert(i + shift);
        return hexadecimal(set);
      };
      both.nodes.push_back(fmt::format("{}{} {} {}{}", line.substr(0, sets), block,
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
  for (const auto& record : certificate.records) {
    const auto proof_result = proof.proof_result(record);
    if (proof_result.except_large_displacements) ++result.except_large_displacements;
    if (proof_result.unloaded) ++result.unloaded;
    if (proof_result.refusal) {
      result.refusals.push_back(*proof_result.refusal);
    } else if (record.claim == Claim::feasible) {
      result.feasible.insert(record.contact);
    } else {
      ++(record.claim == Claim::none ? result.marginal : result.infeasible);
    }
  }
  if (auto flaw = flaw_of_cover(certificate)) result.refusals.push_back(*flaw);
  return result;
}

}  // namespace kusabi::verify
