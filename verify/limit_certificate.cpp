// Writing and reading the file, section by section.
#include "verify/limit_certificate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

#include "support/sha1.hpp"
#include "verify/lines.hpp"

namespace kusabi::verify {
namespace {

/// More of anything than this is no truss but a damaged number, and would only cost memory.
constexpr std::uint64_t most = 10'000'000;

void put(std::string& text, double value) {
  std::array<char, 64> digits{};
  const bool negative = value < 0;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value),
                                 std::chars_format::hex)
                       .ptr;
  text += negative ? " -0x" : " 0x";
  text.append(digits.data(), end);
}

void put(std::string& text, std::size_t value) {
  text += ' ';
  text += std::to_string(value);
}

void put(std::string& text, const std::vector<double>& values) {
  for (const double value : values) put(text, value);
}

void put(std::string& text, const Sparse& entries) {
  put(text, entries.size());
  for (const auto& [place, value] : entries) {
    put(text, place);
    put(text, value);
  }
}

// One number where they are all the same.
void put_half_widths(std::string& text, const std::vector<double>& alpha) {
  if (std::ranges::adjacent_find(alpha, std::not_equal_to()) != alpha.end()) {
    put(text, alpha);
  } else {
    put(text, alpha.empty() ? 0.0 : alpha.front());
  }
}

std::size_t count(Lines& lines, const std::string& keyword) {
  const std::string what = "'" + keyword + "' and a number";
  lines.next();
  lines.expect_word(keyword, what);
  const auto value = lines.integer(10, what);
  if (value > most) lines.refuse(what + " of at most " + std::to_string(most));
  // Each takes a line or a number at least: no memory for what the file cannot hold.
  if (value > lines.left()) lines.refuse(what + " that the rest of the file holds");
  lines.end_of_line(what);
  return value;
}

std::size_t place(Lines& lines, std::size_t size, const std::string& what) {
  const auto value = lines.integer(10, what);
  if (value >= size) lines.refuse(what + " below " + std::to_string(size));
  return value;
}

Sparse sparse(Lines& lines, std::size_t size, const std::string& what) {
  const auto expected = "the number of " + what;
  const auto number = place(lines, size + 1, expected);
  constexpr std::size_t shortest = 4;  // characters of a place and a number, "0 0x0"
  if (number > lines.remainder().size() / shortest) lines.refuse(expected + " that the line holds");
  Sparse entries(number);
  for (auto& [at, value] : entries) {
    at = place(lines, size, "the place of one of the " + what);
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

// One for all columns, or one for each.
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

void read_problem(Lines& lines, LimitCertificate& certificate) {
  lines.expect(limit_first_line);
  certificate.displacements = count(lines, "displacements");
  const auto members = count(lines, "members");
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
  certificate.dead = vector(lines, "dead", certificate.displacements);
  certificate.reference = vector(lines, "reference", certificate.displacements);
  const auto uncertain = count(lines, "uncertain");
  for (std::size_t j = 0; j < uncertain; ++j) {
    lines.next();
    const std::string what = "'column', and displacements with a number that is not 0";
    lines.expect_word("column", what);
    auto& column = certificate.uncertain.emplace_back();
    do {
      const auto at = place(lines, certificate.displacements, what);
      column.emplace_back(at, lines.number(what));
      if (column.back().second == 0) lines.refuse(what);
    } while (!lines.remainder().empty());
    lines.end_of_line(what);
  }
  read_half_widths(lines, certificate);
}

LimitCut read_cut(Lines& lines, const LimitCertificate& certificate) {
  const std::string what = "'cut', a column of T, a factor, and forces";
  lines.expect_word("cut", what);
  LimitCut cut;
  cut.column = place(lines, certificate.uncertain.size(), what);
  cut.factor = lines.number(what);
  cut.forces = sparse(lines, certificate.members(), "forces");
  lines.end_of_line(what);
  return cut;
}

LimitNode read_node(Lines& lines, const LimitCertificate& certificate, std::size_t nodes) {
  const std::string what = "'node', signs, shares of cuts, a factor, and forces";
  lines.expect_word("node", what);
  // A line says something of each column, but for those whose shares are zero.
  constexpr std::uint64_t most_signs = 1'000'000;
  if (certificate.uncertain.size() > lines.remainder().size() &&
      certificate.uncertain.size() * nodes > most_signs) {
    lines.refuse("a sign or a share for each column of T");
  }
  LimitNode node;
  node.line = lines.number();
  node.signs.assign(certificate.uncertain.size(), 0);
  node.one_sided.assign(certificate.uncertain.size(), 0);
  const auto decided = place(lines, certificate.uncertain.size() + 1, "the number of signs");
  for (std::size_t d = 0; d < decided; ++d) {
    const auto at = place(lines, certificate.uncertain.size(), "a column of T");
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

}  // namespace

LimitColumn::LimitColumn(const Sparse& load) : direction(load) {
  if (load.size() != 1) return;
  weight = std::abs(load.front().second);
  direction.front().second = std::copysign(1.0, load.front().second);
}

std::string limit_certificate_text(const LimitCertificate& certificate) {
  std::string text(limit_first_line);
  text += "\ndisplacements " + std::to_string(certificate.displacements);
  text += "\nmembers " + std::to_string(certificate.members());
  for (std::size_t i = 0; i < certificate.members(); ++i) {
    text += "\nmember";
    put(text, certificate.tension[i]);
    put(text, certificate.compression[i]);
    put(text, certificate.columns[i]);
  }
  text += "\ndead";
  put(text, certificate.dead);
  text += "\nreference";
  put(text, certificate.reference);
  text += "\nuncertain " + std::to_string(certificate.uncertain.size());
  for (const auto& column : certificate.uncertain) {
    text += "\ncolumn";
    for (const auto& [at, value] : column) {
      put(text, at);
      put(text, value);
    }
  }
  text += "\nalpha";
  put_half_widths(text, certificate.alpha);
  text += "\nload";
  put(text, certificate.load);
  text += "\nmotion";
  put(text, certificate.motion);
  text += "\ncuts " + std::to_string(certificate.cuts.size());
  for (const auto& cut : certificate.cuts) {
    text += "\ncut";
    put(text, cut.column);
    put(text, cut.factor);
    put(text, cut.forces);
  }
  text += "\nnodes " + std::to_string(certificate.nodes.size());
  for (const auto& node : certificate.nodes) {
    std::size_t decided = 0;
    for (const int sign : node.signs) decided += sign == 0 ? 0 : 1;
    text += "\nnode";
    put(text, decided);
    for (std::size_t j = 0; j < node.signs.size(); ++j) {
      if (node.signs[j] == 0) continue;
      put(text, j);
      text += node.signs[j] > 0 ? " +" : " -";
      put(text, node.one_sided[j]);
    }
    put(text, node.shares);
    put(text, node.factor);
    put(text, node.forces);
  }
  text += "\nend\n";
  text += "digest " + support::hexadecimal(support::sha1(text)) + "\n";
  return text;
}

LimitCertificate read_limit_certificate(std::string_view text, const std::string& file) {
  Lines(text, file).expect(limit_first_line);
  Lines lines(without_digest(text, file), file);
  LimitCertificate certificate;
  read_problem(lines, certificate);
  certificate.load = vector(lines, "load", certificate.uncertain.size());
  certificate.motion = vector(lines, "motion", certificate.displacements);
  const auto cuts = count(lines, "cuts");
  for (std::size_t c = 0; c < cuts; ++c) {
    lines.next();
    certificate.cuts.push_back(read_cut(lines, certificate));
  }
  const auto nodes = count(lines, "nodes");
  for (std::size_t n = 0; n < nodes; ++n) {
    lines.next();
    certificate.nodes.push_back(read_node(lines, certificate, nodes));
  }
  lines.expect("end");
  if (!lines.done()) {
    lines.next();
    lines.refuse("the line 'digest …', the last one");
  }
  return certificate;
}

}  // namespace kusabi::verify
