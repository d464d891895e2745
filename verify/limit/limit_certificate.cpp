// Reader of limit-load certificates, section by section.
#include "verify/limit/limit_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

/// Larger counts are refused as damaged numbers before memory is allocated.
constexpr std::uint64_t maximum = 10'000'000;

Sparse sparse(Lines& lines, std::size_t size, const std::string& what) {
  const auto expected = "the number of " + what;
  const auto number = lines.below(size + 1, expected);
  constexpr std::size_t shortest = 4;  // characters of an index and a number, "0 0x0"
  if (number > lines.remainder().size() / shortest) lines.refuse(expected + " that the line holds");
  Sparse entries(number);
  for (auto& [at, value] : entries) {
    at = lines.below(size, "the place of one of the " + what);
    value = lines.number(what);
  }
  return entries;
}

std::vector<double> vector(Lines& lines, const std::string& keyword, std::size_t size) {
  std::vector<double> values;
  lines.next();
  lines.expect_word(keyword, "'" + keyword + "' and its numbers");
  lines.numbers(size, values, "numbers");
  return values;
}

// One half-width for all columns, or one for each.
void read_half_widths(Lines& lines, LimitCertificate& certificate) {
  const std::string what = "'alpha' and a number that is not negative, or one for each column";
  const auto m = certificate.uncertain.size();
  lines.next();
  lines.expect_word("alpha", what);
  auto& alpha = certificate.alpha;
  do {
    alpha.push_back(lines.number(what));
    if (alpha.back() < 0 || alpha.size() > std::max<std::size_t>(m, 1)) lines.refuse(what);
  } while (!lines.remainder().empty());
  lines.end_of_line(what);
  if (alpha.size() != 1 && alpha.size() != m) lines.refuse(what);
  alpha.resize(m, alpha.front());
}

void read_truss(Lines& lines, LimitCertificate& certificate) {
  certificate.displacements = lines.count("displacements", 0, maximum);
  const auto members = lines.count("members", 0, maximum);
  if (members < certificate.displacements) {
    lines.refuse("as many members as displacements at least: a truss of fewer is a mechanism");
  }
  for (std::size_t i = 0; i < members; ++i) {
    lines.next();
    const std::string what = "'member', its yield forces, not negative, and its column of B";
    lines.expect_word("member", what);
    for (auto* yields : {&certificate.tension, &certificate.compression}) {
      yields->push_back(lines.number(what));
      if (yields->back() < 0) lines.refuse(what);
    }
    certificate.columns.push_back(sparse(lines, certificate.displacements, "entries of B"));
    lines.end_of_line(what);
  }
}

void read_columns(Lines& lines, LimitCertificate& certificate) {
  const auto uncertain = lines.count("uncertain", 0, maximum);
  for (std::size_t j = 0; j < uncertain; ++j) {
    lines.next();
    const std::string what = "'column', and displacements with a number that is not 0";
    lines.expect_word("column", what);
    auto& column = certificate.uncertain.emplace_back();
    do {
      const auto at = lines.below(certificate.displacements, what);
      column.emplace_back(at, lines.number(what));
      if (column.back().second == 0) lines.refuse(what);
    } while (!lines.remainder().empty());
    lines.end_of_line(what);
  }
}

void read_names(Lines& lines, LimitCertificate& certificate) {
  const std::string what = "'name', a column that has none yet, and its name";
  const auto m = certificate.uncertain.size();
  const auto named = lines.count("names", 0, maximum);
  certificate.names.resize(m);
  for (std::size_t k = 0; k < named; ++k) {
    lines.next();
    lines.expect_word("name", what);
    auto& name = certificate.names[lines.below(m, what)];
    if (!name.empty() || lines.remainder().empty()) lines.refuse(what);
    name = lines.name();
  }
}

// Version 1 has no names.
void read_loads(Lines& lines, LimitCertificate& certificate, bool with_names) {
  certificate.dead = vector(lines, "dead", certificate.displacements);
  certificate.reference = vector(lines, "reference", certificate.displacements);
  read_columns(lines, certificate);
  if (with_names) read_names(lines, certificate);
  read_half_widths(lines, certificate);
}

LimitCut read_cut(Lines& lines, const LimitCertificate& certificate) {
  const std::string what = "'cut', a column of T, a factor, and forces";
  lines.expect_word("cut", what);
  LimitCut cut;
  cut.column = lines.below(certificate.uncertain.size(), what);
  cut.factor = lines.number(what);
  cut.forces = sparse(lines, certificate.members(), "forces");
  lines.end_of_line(what);
  return cut;
}

LimitNode read_node(Lines& lines, const LimitCertificate& certificate, std::size_t nodes) {
  const std::string what = "'node', signs, shares of cuts, a factor, and forces";
  lines.expect_word("node", what);
  // Columns whose shares are zero have no line.
  constexpr std::uint64_t max_signs = 1'000'000;
  if (certificate.uncertain.size() > lines.remainder().size() &&
      certificate.uncertain.size() * nodes > max_signs) {
    lines.refuse("a sign or a share for each column of T");
  }
  LimitNode node;
  node.line = lines.number();
  node.signs.assign(certificate.uncertain.size(), 0);
  node.one_sided.assign(certificate.uncertain.size(), 0);
  const auto decided = lines.below(certificate.uncertain.size() + 1, "the number of signs");
  for (std::size_t d = 0; d < decided; ++d) {
    const auto at = lines.below(certificate.uncertain.size(), "a column of T");
    const auto sign = lines.word();
    if ((sign != "+" && sign != "-") || node.signs[at] != 0) {
      lines.refuse("'+' or '-' for a column, once");
    }
    node.signs[at] = sign == "+" ? 1 : -1;
    node.one_sided[at] = lines.number("a multiplier that is not negative");
    if (node.one_sided[at] < 0) lines.refuse("a multiplier that is not negative");
  }
  node.shares = sparse(lines, certificate.cuts.size(), "shares of cuts");
  for (const auto& [cut, share] : node.shares) {
    if (share < 0) lines.refuse("shares of cuts that are not negative");
  }
  node.factor = lines.number("a factor");
  lines.numbers(certificate.members(), node.forces, "forces");
  return node;
}

void read_evidence(Lines& lines, LimitCertificate& certificate) {
  certificate.load = vector(lines, "load", certificate.uncertain.size());
  certificate.motion = vector(lines, "motion", certificate.displacements);
  const auto cuts = lines.count("cuts", 0, maximum);
  for (std::size_t c = 0; c < cuts; ++c) {
    lines.next();
    certificate.cuts.push_back(read_cut(lines, certificate));
  }
  const auto nodes = lines.count("nodes", 0, maximum);
  for (std::size_t n = 0; n < nodes; ++n) {
    lines.next();
    certificate.nodes.push_back(read_node(lines, certificate, nodes));
  }
}

// The claim of the current line. @param before the previous claim of the same load case
LimitClaim read_claim(Lines& lines, std::optional<LimitClaim> before) {
  const std::string what = before ? "'claim least', 'residual', 'case' or 'end'"
                                  : "'claim' and 'largest' or 'none', the first of a case";
  lines.expect_word("claim", what);
  const auto word = lines.remainder();
  for (const auto claim : {LimitClaim::largest, LimitClaim::minimum, LimitClaim::none}) {
    if (word != claim_word(claim)) continue;
    const bool fits = claim == LimitClaim::minimum ? before == LimitClaim::largest : !before;
    if (fits) return claim;
  }
  lines.refuse(what);
}

// Claims from the current line on; the line after them becomes the current one.
void read_claims(Lines& lines, const LimitStatement& without_claim,
                 std::vector<LimitStatement>& statements) {
  std::optional<LimitClaim> before;
  do {
    const auto claim = read_claim(lines, before);
    auto& [name, its_claim, evidence, residual] = statements.emplace_back(without_claim);
    its_claim = claim;
    if (claim == LimitClaim::minimum) {
      for (double& value : evidence.reference) value = -value;
    }
    read_evidence(lines, evidence);
    before = claim;
    lines.next();
  } while (lines.text().starts_with("claim"));
}

// Reads from the line 'case' to the next 'case' or 'end', which becomes the current line.
void read_case(Lines& lines, const LimitCertificate& truss,
               std::vector<LimitStatement>& statements) {
  const std::string what = "'case', and a name that no case before it has, or 'end'";
  lines.expect_word("case", what);
  const std::string name(lines.name());
  const bool known =
      std::ranges::find(statements, name, &LimitStatement::load_case) != statements.end();
  if (known) lines.refuse(what);
  LimitStatement statement{name, LimitClaim::largest, truss};
  auto& loads = statement.evidence;
  read_loads(lines, loads, true);
  lines.next();
  read_claims(lines, statement, statements);
  if (!lines.text().starts_with("residual")) return;
  loads.compression = read_residual_strengths(lines, loads.compression);
  statement.residual = true;
  lines.next();
  read_claims(lines, statement, statements);
}

std::vector<LimitStatement> read_statements(Lines& lines) {
  LimitCertificate truss;
  read_truss(lines, truss);
  std::vector<LimitStatement> statements;
  lines.next();
  do {
    read_case(lines, truss, statements);
  } while (lines.text() != "end");
  return statements;
}

}  // namespace

LimitColumn::LimitColumn(const Sparse& load) : direction(load) {
  if (load.size() != 1) return;
  weight = std::abs(load.front().second);
  direction.front().second = std::copysign(1.0, load.front().second);
}

std::vector<double> read_residual_strengths(Lines& lines, const std::vector<double>& strengths) {
  const std::string what =
      "'residual' and a strength for each member, not negative and at most that in compression";
  lines.expect_word("residual", what);
  std::vector<double> residual;
  lines.numbers(strengths.size(), residual, what);
  for (std::size_t i = 0; i < residual.size(); ++i) {
    if (residual[i] < 0 || residual[i] > strengths[i]) lines.refuse(what);
  }
  return residual;
}

std::string_view claim_word(LimitClaim claim) {
  switch (claim) {
    case LimitClaim::largest:
      return "largest";
    case LimitClaim::minimum:
      return "least";
    case LimitClaim::none:
      break;
  }
  return "none";
}

std::vector<LimitStatement> read_limit_certificate(std::string_view text, const std::string& file) {
  auto lines = lines_after(limit_first_line, text, file);
  auto statements = read_statements(lines);
  lines.expect_end();
  return statements;
}

}  // namespace kusabi::verify
