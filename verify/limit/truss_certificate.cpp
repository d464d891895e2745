// Reader of certificates of trusses, record by record.
#include "verify/limit/truss_certificate.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

/// Larger products of counts, whose memory no single line accounts for, are refused.
constexpr std::size_t maximum = 10'000'000;
constexpr std::size_t max_numbers = 200'000'000;

void begin(Lines& lines, const std::string& keyword, const std::string& what) {
  lines.next();
  lines.expect_word(keyword, "'" + keyword + "'" + what);
}

double not_negative(Lines& lines, const std::string& what) {
  const double value = lines.number(what);
  if (value < 0) lines.refuse(what + ", not negative");
  return value;
}

/// A number of items in the rest of the line, each of at least `shortest` characters.
std::size_t items(Lines& lines, std::size_t shortest, const std::string& what) {
  const auto count = lines.integer(10, "the number of " + what);
  if (count > lines.remainder().size() / shortest)
    lines.refuse("the number of " + what + " that the line holds");
  return count;
}

Sparse sparse(Lines& lines, std::size_t size, const std::string& what) {
  constexpr std::size_t shortest = 4;  // "0 0x0"
  Sparse entries(items(lines, shortest, what));
  for (auto& [at, value] : entries) {
    at = lines.below(size, "the place of one of the " + what);
    value = lines.number(what);
  }
  return entries;
}

std::vector<double> vector(Lines& lines, const std::string& keyword, std::size_t size) {
  std::vector<double> values;
  begin(lines, keyword, " and its numbers");
  lines.numbers(size, values, "numbers");
  return values;
}

// A number of members, and the members in ascending order.
std::vector<std::size_t> members(Lines& lines, const Structure& truss) {
  const std::string what = "ascending members";
  std::vector<std::size_t> numbers(items(lines, 1, what));
  for (auto& number : numbers) {
    number = lines.below(truss.bars.size(), what);
    if (&number != numbers.data() && number <= *(&number - 1)) lines.refuse(what);
  }
  return numbers;
}

Structure read_truss(Lines& lines) {
  Structure truss;
  truss.dimension = lines.count("dimension", 2, 3);
  const auto nodes = lines.count("nodes");
  const std::string of_node = " and for each axis a coordinate and 'fixed' or 'free'";
  for (std::size_t k = 0; k < nodes; ++k) {
    begin(lines, "node", of_node);
    auto& place = truss.coordinates.emplace_back();
    auto& fixed = truss.fixed.emplace_back();
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) {
      place[axis] = lines.number("a coordinate");
      const auto word = lines.word();
      if (word != "fixed" && word != "free") lines.refuse("'node'" + of_node);
      fixed[axis] = word == "fixed";
    }
    lines.end_of_line("'node'" + of_node);
    truss.names.push_back(std::to_string(k));
  }
  const auto bars = lines.count("members");
  const std::string of_bar =
      "two nodes at different places, and yield forces in tension, in compression and after "
      "buckling, "
      "the last one at most the second";
  for (std::size_t k = 0; k < bars; ++k) {
    begin(lines, "member", ", " + of_bar);
    auto& bar = truss.bars.emplace_back();
    bar.first = lines.below(nodes, of_bar);
    bar.second = lines.below(nodes, of_bar);
    if (truss.coordinates[bar.first] == truss.coordinates[bar.second]) lines.refuse(of_bar);
    bar.tension = not_negative(lines, of_bar);
    bar.compression = not_negative(lines, of_bar);
    bar.residual = not_negative(lines, of_bar);
    if (bar.residual > bar.compression) lines.refuse(of_bar);
    lines.end_of_line(of_bar);
  }
  return truss;
}

std::vector<Force> read_forces(Lines& lines, const Structure& truss, const std::string& keyword) {
  std::vector<Force> forces;
  for (auto left = lines.count(keyword); left > 0; --left) {
    begin(lines, "force", ", a node and its components");
    auto& force = forces.emplace_back();
    force.node = lines.below(truss.coordinates.size(), "a node");
    for (std::size_t axis = 0; axis < truss.dimension; ++axis)
      force.components[axis] = lines.number("components of a force");
    lines.end_of_line("as many components as axes");
  }
  return forces;
}

/// A load case: its name, and the truss with its loads.
using Case = std::pair<std::string, Structure>;

Case read_case(Lines& lines, Structure truss) {
  begin(lines, "case", " and a name");
  const std::string name(lines.name());
  truss.dead = read_forces(lines, truss, "dead");
  truss.reference = read_forces(lines, truss, "reference");
  truss.uncertain.emplace();
  const std::string what = "a half-width, and components, not zero, on free displacements";
  for (auto left = lines.count("uncertain"); left > 0; --left) {
    begin(lines, "column", ", " + what);
    truss.half_widths.emplace_back(not_negative(lines, what));
    auto& column = truss.uncertain->emplace_back(items(lines, 7, "components"));
    for (auto& part : column) {
      part.node = lines.below(truss.coordinates.size(), what);
      part.axis = lines.below(truss.dimension, what);
      part.weight = lines.number(what);
      if (part.weight == 0 || truss.fixed[part.node][part.axis]) lines.refuse(what);
    }
    if (column.empty()) lines.refuse(what);
    truss.load_names.emplace_back(lines.name());
  }
  return {name, std::move(truss)};
}

LimitCut read_cut(Lines& lines, const TrussTheorem& theorem) {
  begin(lines, "cut", ", a column of T, a factor, and forces");
  LimitCut cut;
  cut.column = lines.below(theorem.truss.uncertain->size(), "a column of T");
  cut.factor = lines.number("a factor");
  cut.forces = sparse(lines, theorem.truss.bars.size(), "forces");
  lines.end_of_line("the end of the forces");
  return cut;
}

LimitNode read_node(Lines& lines, const TrussTheorem& theorem, std::size_t nodes) {
  begin(lines, "node", ", signs, shares of cuts, a factor, and forces");
  // Columns whose shares are zero have no line.
  const auto columns = theorem.truss.uncertain->size();
  constexpr std::uint64_t max_signs = 1'000'000;
  if (columns > lines.remainder().size() && columns * nodes > max_signs)
    lines.refuse("a sign or a share for each column of T");
  LimitNode node;
  node.line = lines.number();
  node.signs.assign(columns, 0);
  node.one_sided.assign(columns, 0);
  for (auto left = lines.below(columns + 1, "the number of signs"); left > 0; --left) {
    const auto at = lines.below(columns, "a column of T");
    const auto sign = lines.word();
    if ((sign != "+" && sign != "-") || node.signs[at] != 0)
      lines.refuse("'+' or '-' for a column, once");
    node.signs[at] = sign == "+" ? 1 : -1;
    node.one_sided[at] = not_negative(lines, "a multiplier");
  }
  node.shares = sparse(lines, theorem.cuts.size(), "shares of cuts");
  for (const auto& [cut, share] : node.shares) {
    if (share < 0) lines.refuse("shares of cuts that are not negative");
  }
  node.factor = lines.number("a factor");
  lines.numbers(theorem.truss.bars.size(), node.forces, "forces");
  return node;
}

StressState read_state(Lines& lines, const TrussTheorem& theorem) {
  StressState state;
  begin(lines, "state", " and its members");
  state.support = members(lines, theorem.truss);
  lines.end_of_line("the end of the members");
  const std::string what = "members of the support, ascending, with a force";
  for (std::size_t load = 0; load <= theorem.truss.uncertain->size(); ++load) {
    begin(lines, "forces", ", a factor, and " + what);
    auto& column = state.columns.emplace_back();
    column.factor = lines.number("a factor");
    column.forces = sparse(lines, theorem.truss.bars.size(), what);
    for (std::size_t k = 0; k < column.forces.size(); ++k) {
      const auto member = column.forces[k].first;
      if (!std::ranges::binary_search(state.support, member) ||
          (k > 0 && member <= column.forces[k - 1].first))
        lines.refuse(what);
    }
    lines.end_of_line(what);
  }
  return state;
}

std::size_t free_displacements(const Structure& truss) {
  std::size_t free = 0;
  for (const auto& node : truss.fixed) {
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) free += node[axis] ? 0 : 1;
  }
  return free;
}

// The fields of the line 'theorem' after the load case.
TrussTheorem read_fields(Lines& lines, const Structure& truss) {
  const std::string what =
      "'largest', 'least' or 'none', 'strength' or 'residual', and losses, none with factor 1";
  TrussTheorem theorem;
  const auto claim = lines.word();
  const auto strength = lines.word();
  if (claim == "least") theorem.claim = LimitClaim::minimum;
  if (claim == "none") theorem.claim = LimitClaim::none;
  theorem.residual = strength == "residual";
  if (claim != claim_word(theorem.claim) || (!theorem.residual && strength != "strength"))
    lines.refuse(what);
  theorem.losses = lines.below(truss.bars.size() + 1, what);
  theorem.sudden = lines.number(what);
  theorem.kept = members(lines, truss);
  lines.end_of_line(what);
  const bool lost = theorem.losses > 0;
  if (theorem.sudden < 1 || (!lost && (theorem.sudden > 1 || !theorem.kept.empty())))
    lines.refuse(what);
  return theorem;
}

// True if a theorem on a load case may follow another one, and if its losses are the same.
bool may_follow(const TrussTheorem& theorem, bool same_case, const TrussTheorem* before) {
  const bool least = theorem.claim == LimitClaim::minimum;
  if (before == nullptr || !same_case) {
    if (theorem.residual || least) return false;
  } else if (theorem.residual == before->residual) {
    if (!least || before->claim != LimitClaim::largest || theorem.losses > 0) return false;
  } else if (!theorem.residual || least) {
    return false;
  }
  return before == nullptr || (theorem.losses == before->losses &&
                               theorem.sudden == before->sudden && theorem.kept == before->kept);
}

CollapseMotion read_collapse(Lines& lines, const TrussTheorem& theorem) {
  const std::string what = "members, at most as many as are lost, and none that are kept";
  CollapseMotion collapse;
  begin(lines, "lost", ", " + what);
  collapse.lost = members(lines, theorem.truss);
  lines.end_of_line(what);
  const auto kept = [&](std::size_t i) { return std::ranges::binary_search(theorem.kept, i); };
  if (collapse.lost.size() > theorem.losses || std::ranges::any_of(collapse.lost, kept))
    lines.refuse(what);
  collapse.load = vector(lines, "load", theorem.truss.uncertain->size());
  collapse.motion = vector(lines, "motion", free_displacements(theorem.truss));
  return collapse;
}

// Evidence of a lower bound: cuts and nodes without losses, states with losses. A proof has a number
// for each displacement of a cut, and for each member of a state.
void read_lower(Lines& lines, TrussTheorem& theorem) {
  if (theorem.losses == 0) {
    const auto displacements = std::max<std::size_t>(1, free_displacements(theorem.truss));
    for (auto left = lines.count("cuts", 0, max_numbers / displacements); left > 0; --left)
      theorem.cuts.push_back(read_cut(lines, theorem));
    const auto nodes = lines.count("nodes");
    for (auto left = nodes; left > 0; --left)
      theorem.nodes.push_back(read_node(lines, theorem, nodes));
    return;
  }
  const std::string what = "a number of states, and their lower bound if there are any";
  begin(lines, "states", ", " + what);
  const auto states = lines.integer(10, what);
  if (states > std::min(lines.left(), max_numbers / theorem.truss.bars.size())) lines.refuse(what);
  if (states > 0) theorem.lower = lines.number(what);
  lines.end_of_line(what);
  for (auto left = states; left > 0; --left) theorem.states.push_back(read_state(lines, theorem));
}

// A number of load cases or theorems, each of which has its own copy of the truss.
std::size_t count_copies(Lines& lines, const std::string& keyword, const Structure& truss) {
  const auto count = lines.count(keyword, 1);
  if (count > maximum / (truss.bars.size() + truss.coordinates.size() + 1))
    lines.refuse("fewer " + keyword + " for a truss of this size");
  return count;
}

std::vector<Case> read_cases(Lines& lines, const Structure& truss) {
  std::vector<Case> cases;
  const auto count = count_copies(lines, "cases", truss);
  for (auto left = count; left > 0; --left) {
    auto next = read_case(lines, truss);
    // A case without a name is one of those of the file, which have names.
    if ((count > 1 && next.first.empty()) ||
        std::ranges::find(cases, next.first, &Case::first) != cases.end())
      lines.refuse("different names of load cases; only a single one may have none");
    cases.push_back(std::move(next));
  }
  return cases;
}

}  // namespace

std::string_view claim_word(LimitClaim claim) {
  return claim == LimitClaim::largest ? "largest" : claim == LimitClaim::minimum ? "least" : "none";
}

std::vector<TrussTheorem> read_truss_certificate(std::string_view text, const std::string& file) {
  auto lines = lines_after(truss_first_line, text, file);
  const auto truss = read_truss(lines);
  const auto cases = read_cases(lines, truss);
  const auto count = count_copies(lines, "theorems", truss);
  const std::string what =
      "'theorem' and its load case: for each at strength, 'none' or 'largest' and then 'least', "
      "and then at residual strength, with the same losses";
  std::vector<TrussTheorem> theorems;
  std::size_t last = 0;  // load case, counted from 1
  for (std::size_t k = 0; k < count; ++k) {
    begin(lines, "theorem", " and its fields");
    const auto number = lines.integer(10, what);
    auto theorem = read_fields(lines, truss);
    if (number == 0 || number > cases.size() || (number != last && number != last + 1) ||
        !may_follow(theorem, number == last, theorems.empty() ? nullptr : &theorems.back()))
      lines.refuse(what);
    last = number;
    std::tie(theorem.load_case, theorem.truss) = cases[number - 1];
    theorem.collapse = read_collapse(lines, theorem);
    if (theorem.claim != LimitClaim::none) read_lower(lines, theorem);
    theorems.push_back(std::move(theorem));
  }
  if (last != cases.size()) lines.refuse("a theorem on each load case");
  lines.expect("end");
  lines.expect_end();
  return theorems;
}

}  // namespace kusabi::verify
