// Reader of certificates of the loss of members, line by line.
#include "verify/limit/loss_certificate.hpp"

#include <algorithm>
#include <utility>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

/// A number of items, each of which takes some of the text that is left.
std::size_t count(Lines& lines, std::size_t text_left, const std::string& what) {
  const auto value = lines.integer(10, what);
  if (value > text_left) lines.refuse(what + " that the rest of the file holds");
  return value;
}

double not_negative(Lines& lines, const std::string& what) {
  const double value = lines.number(what);
  if (value < 0) lines.refuse(what + " that is not negative");
  return value;
}

void begin(Lines& lines, std::string_view keyword, const std::string& what) {
  lines.next();
  lines.expect_word(keyword, what);
}

// Ascending numbers of members.
std::vector<std::size_t> members(Lines& lines, const Structure& truss, const std::string& what) {
  std::vector<std::size_t> numbers(count(lines, lines.remainder().size(), what));
  for (auto& number : numbers) {
    number = lines.below(truss.bars.size(), what);
    if (&number != numbers.data() && number <= *(&number - 1)) lines.refuse(what);
  }
  return numbers;
}

Structure read_truss(Lines& lines) {
  Structure truss;
  begin(lines, "dimension", "'dimension' and 2 or 3");
  truss.dimension = lines.integer(10, "2 or 3");
  if (truss.dimension != 2 && truss.dimension != 3) lines.refuse("2 or 3");
  const auto nodes = lines.count("nodes");
  const std::string of_node = "'node', and for each axis a coordinate and 'fixed' or 'free'";
  for (std::size_t k = 0; k < nodes; ++k) {
    begin(lines, "node", of_node);
    auto& place = truss.coordinates.emplace_back();
    auto& fixed = truss.fixed.emplace_back();
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) {
      place[axis] = lines.number(of_node);
      const auto word = lines.word();
      if (word != "fixed" && word != "free") lines.refuse(of_node);
      fixed[axis] = word == "fixed";
    }
    lines.end_of_line(of_node);
    truss.names.push_back(std::to_string(k));
  }
  const auto bars = lines.count("members");
  const std::string of_bar = "'member', two nodes and its yield forces, not negative";
  for (std::size_t k = 0; k < bars; ++k) {
    begin(lines, "member", of_bar);
    auto& bar = truss.bars.emplace_back();
    bar.first = lines.below(nodes, of_bar);
    bar.second = lines.below(nodes, of_bar);
    if (truss.coordinates[bar.first] == truss.coordinates[bar.second])
      lines.refuse("two nodes at different places");
    bar.tension = not_negative(lines, of_bar);
    bar.compression = not_negative(lines, of_bar);
    lines.end_of_line(of_bar);
  }
  return truss;
}

std::vector<Force> read_forces(Lines& lines, const Structure& truss, const std::string& keyword) {
  std::vector<Force> forces;
  const std::string what = "'force', a node and its components";
  for (auto left = lines.count(keyword); left > 0; --left) {
    begin(lines, "force", what);
    auto& force = forces.emplace_back();
    force.node = lines.below(truss.coordinates.size(), what);
    for (std::size_t axis = 0; axis < truss.dimension; ++axis)
      force.components[axis] = lines.number(what);
    lines.end_of_line(what);
  }
  return forces;
}

void read_loads(Lines& lines, Structure& truss) {
  truss.dead = read_forces(lines, truss, "dead");
  truss.reference = read_forces(lines, truss, "reference");
  auto& uncertain = truss.uncertain.emplace();
  const std::string what = "'column', a half-width, and components";
  for (auto left = lines.count("uncertain"); left > 0; --left) {
    begin(lines, "column", what);
    truss.half_widths.emplace_back(not_negative(lines, what));
    auto& column = uncertain.emplace_back();
    for (auto parts = count(lines, lines.remainder().size(), what); parts > 0; --parts) {
      auto& part = column.emplace_back();
      part.node = lines.below(truss.coordinates.size(), what);
      part.axis = lines.below(truss.dimension, what);
      part.weight = lines.number(what);
    }
    truss.load_names.emplace_back(lines.name());
  }
}

StressColumn read_column(Lines& lines, const LossStatement& statement,
                         const std::vector<std::size_t>& support) {
  const std::string what = "'forces', a factor, and members of the support with a force";
  begin(lines, "forces", what);
  StressColumn column{lines.number(what), {}};
  for (auto left = count(lines, lines.remainder().size(), what); left > 0; --left) {
    const auto member = lines.below(statement.truss.bars.size(), what);
    const bool after = column.forces.empty() || column.forces.back().first < member;
    if (!after || !std::ranges::binary_search(support, member)) lines.refuse(what);
    column.forces.emplace_back(member, lines.number(what));
  }
  lines.end_of_line(what);
  return column;
}

void read_numbers(Lines& lines, const std::string& keyword, std::size_t size,
                  std::vector<double>& values) {
  begin(lines, keyword, "'" + keyword + "' and its numbers");
  lines.numbers(size, values, "numbers");
}

std::size_t free_displacements(const Structure& truss) {
  std::size_t free = 0;
  for (const auto& node : truss.fixed) {
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) free += node[axis] ? 0 : 1;
  }
  return free;
}

void read_claim(Lines& lines, LossStatement& statement) {
  const auto& truss = statement.truss;
  const std::string of_loss = "'lose', a number of members above 0, and a factor of at least 1";
  begin(lines, "lose", of_loss);
  statement.maximum = lines.integer(10, of_loss);
  statement.sudden = lines.number(of_loss);
  if (statement.maximum == 0 || statement.maximum > truss.bars.size() || statement.sudden < 1)
    lines.refuse(of_loss);
  lines.end_of_line(of_loss);
  begin(lines, "kept", "'kept' and members");
  statement.kept = members(lines, truss, "ascending members");
  const std::string of_lost =
      "'lost', members, at most as many as are lost, and none that are kept";
  begin(lines, "lost", of_lost);
  statement.lost = members(lines, truss, of_lost);
  if (statement.lost.size() > statement.maximum) lines.refuse(of_lost);
  for (const auto member : statement.lost) {
    if (std::ranges::binary_search(statement.kept, member)) lines.refuse(of_lost);
  }
  const auto word = lines.remainder();
  if (!word.empty() && word != "fatal") lines.refuse("'fatal' or nothing");
  statement.fatal = !word.empty();
  read_numbers(lines, "load", truss.uncertain->size(), statement.load);
  read_numbers(lines, "motion", free_displacements(truss), statement.motion);
  begin(lines, "lower", "'lower' and a number or nothing");
  if (!lines.remainder().empty()) statement.lower = lines.number("a number");
  if (statement.fatal && statement.lower) lines.refuse("no lower bound of a fatal loss");
  const auto states = lines.count("states");
  if (states > 0 && !statement.lower) lines.refuse("no states without a lower bound");
  for (auto left = states; left > 0; --left) {
    auto& state = statement.states.emplace_back();
    begin(lines, "state", "'state' and its members");
    state.support = members(lines, truss, "ascending members of a state");
    for (std::size_t load = 0; load <= truss.uncertain->size(); ++load)
      state.columns.push_back(read_column(lines, statement, state.support));
  }
}

// The claim at residual strength, from the current line on.
LossStatement read_residual(Lines& lines, LossStatement statement) {
  std::vector<double> strengths;
  for (const auto& bar : statement.truss.bars) strengths.push_back(bar.compression);
  strengths = read_residual_strengths(lines, strengths);
  for (std::size_t i = 0; i < strengths.size(); ++i)
    statement.truss.bars[i].compression = strengths[i];
  statement.residual = true;
  read_claim(lines, statement);
  return statement;
}

}  // namespace

std::vector<LossStatement> read_loss_certificate(std::string_view text, const std::string& file) {
  auto lines = lines_after(loss_first_line, text, file);
  const auto truss = read_truss(lines);
  std::vector<LossStatement> statements;
  lines.next();
  do {
    const std::string what = "'case', and a name that no case before it has, or 'end'";
    lines.expect_word("case", what);
    const std::string name(lines.name());
    if (std::ranges::find(statements, name, &LossStatement::load_case) != statements.end())
      lines.refuse(what);
    LossStatement without_claim;
    without_claim.load_case = name;
    without_claim.truss = truss;
    read_loads(lines, without_claim.truss);
    read_claim(lines, statements.emplace_back(without_claim));
    lines.next();
    if (!lines.text().starts_with("residual")) continue;
    statements.push_back(read_residual(lines, std::move(without_claim)));
    lines.next();
  } while (lines.text() != "end");
  lines.expect_end();
  return statements;
}

}  // namespace kusabi::verify
