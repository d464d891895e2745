// Reader of certificates: the problem. Theorems with their nodes, and bounds, have files of their
// own.
#include "verify/wedged/certificate.hpp"

#include <algorithm>
#include <map>

#include "verify/wedged/certificate_lines.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

// Larger counts exceed any search; K would have more than 10^8 entries.
constexpr std::size_t max_candidates = 4096;

void read_names(Lines& lines, std::size_t count, Certificate& certificate) {
  std::map<std::string_view, std::size_t> lines_of;  // names are views of the text
  for (std::size_t i = 0; i < count; ++i) {
    lines.next();
    lines.expect_word("name", "'name' and the name of contact candidate " + std::to_string(i + 1));
    const auto name = lines.name();
    if (name.empty()) lines.refuse("a name that is not empty");
    const auto [same, is_new] = lines_of.emplace(name, lines.number());
    if (!is_new) lines.refuse("a name other than that of line " + std::to_string(same->second));
    certificate.names.emplace_back(name);
  }
}

// By candidate, the number of its block.
std::vector<std::size_t> block_numbers(const Certificate& certificate) {
  std::vector<std::size_t> numbers(certificate.candidates());
  for (std::size_t b = 0; b < certificate.blocks.size(); ++b) {
    for (const int candidate : certificate.blocks[b]) {
      numbers[static_cast<std::size_t>(candidate)] = b;
    }
  }
  return numbers;
}

void read_stiffness(Lines& lines, Certificate& certificate) {
  lines.expect("stiffness");
  const auto size = certificate.displacements();
  const auto d = certificate.dimension;
  const auto block = block_numbers(certificate);
  certificate.stiffness.resize(size * size);
  std::vector<double> row;
  for (std::size_t i = 0; i < size; ++i) {
    lines.next();
    row.clear();
    lines.numbers(i + 1, row, "entries of row " + std::to_string(i + 1) + " of the stiffness");
    for (std::size_t j = 0; j <= i; ++j) {
      if (block[i / d] != block[j / d] && row[j] != 0) {
        lines.refuse("0x0p+0 as entry " + std::to_string(j + 1) + ", which couples two blocks");
      }
      certificate.stiffness[size * i + j] = certificate.stiffness[size * j + i] = row[j];
    }
  }
}

void read_header(Lines& lines, Certificate& certificate) {
  const std::string dimension = "'dimension 2' or 'dimension 3'";
  lines.next();
  lines.expect_word("dimension", dimension);
  certificate.dimension = lines.integer(10, dimension);
  if (certificate.dimension != 2 && certificate.dimension != 3) lines.refuse(dimension);
  lines.end_of_line(dimension);
  const auto m = lines.count("candidates", 1, max_candidates);
  read_names(lines, m, certificate);
  lines.next();
  lines.expect_word("friction", "'friction' and a coefficient for each contact candidate");
  lines.numbers(m, certificate.friction, "friction coefficients");
  if (*std::min_element(certificate.friction.begin(), certificate.friction.end()) < 0) {
    lines.refuse("friction coefficients that are not negative");
  }
}

void read_blocks(Lines& lines, Certificate& certificate) {
  const auto count = lines.count("blocks", 1, certificate.candidates());
  auto left = certificate.all_candidates();
  for (std::uint64_t b = 0; b < count; ++b) {
    lines.next();
    const std::string what = "'block' and its contact candidates, in hexadecimal digits";
    lines.expect_word("block", what);
    const auto block = lines.set(what);
    lines.end_of_line(what);
    if (block.empty() || !left.includes(block)) {
      lines.refuse("contact candidates that no other block has");
    }
    if (block.lowest() != left.lowest()) {
      lines.refuse("the block of " + certificate.names[static_cast<std::size_t>(left.lowest())] +
                   ", the first candidate without one");
    }
    left -= block;
    certificate.blocks.push_back(block);
  }
  if (!left.empty())
    lines.refuse("all contact candidates in the blocks, but " + certificate.names_of(left) +
                 " are in none");
}

void read_motions(Lines& lines, Certificate& certificate) {
  const auto count = lines.count("motions", 0, certificate.displacements());
  certificate.motions = count;
  if (count == 0) return;
  const auto numbers = block_numbers(certificate);
  std::vector<std::size_t> block_of(count, certificate.blocks.size());
  std::vector<double> row;
  for (std::size_t i = 0; i < certificate.displacements(); ++i) {
    lines.next();
    row.clear();
    lines.numbers(count, row, "entries of row " + std::to_string(i + 1) + " of the motions");
    const auto own = numbers[i / certificate.dimension];
    for (std::size_t k = 0; k < count; ++k) {
      if (row[k] == 0) continue;
      if (block_of[k] == certificate.blocks.size()) block_of[k] = own;
      if (block_of[k] != own)
        lines.refuse("0x0p+0 as entry " + std::to_string(k + 1) +
                     ", since the mode belongs to another block");
    }
    certificate.motion_values.insert(certificate.motion_values.end(), row.begin(), row.end());
  }
}

// A line of numbers after a word.
std::vector<double> read_list(Lines& lines, const std::string& word, std::size_t count,
                              const std::string& what) {
  lines.next();
  lines.expect_word(word, "'" + word + "' and " + what);
  std::vector<double> list;
  lines.numbers(count, list, what);
  return list;
}

// The line 'total P', or 'total' alone.
void read_total(Lines& lines, Certificate& certificate) {
  const std::string what = "'total' and a force above zero, or none";
  lines.next();
  lines.expect_word("total", what);
  if (lines.remainder().empty()) return lines.end_of_line(what);
  certificate.total = lines.number(what);
  if (*certificate.total <= 0) lines.refuse(what);
  if (certificate.blocks.size() != 1) lines.refuse("no total, since it is that of one block");
  lines.end_of_line(what);
}

void read_loads(Lines& lines, Certificate& certificate) {
  const auto count = lines.count("loads", 0, 2);
  if (count == 0) return;
  if (count == 1) lines.refuse("'loads 0' or 'loads 2', the dead and the reference load");
  auto& loads = certificate.loads.emplace();
  lines.next();
  lines.expect_word("case", "'case' and the name of a load case, or none");
  loads.load_case = lines.name();
  loads.clearance = read_list(lines, "clearance", certificate.candidates(), "clearances");
  loads.dead = read_list(lines, "dead", certificate.displacements(), "forces of the dead load");
  loads.reference =
      read_list(lines, "reference", certificate.displacements(), "forces of the reference load");
  read_total(lines, certificate);
}

}  // namespace

std::string Certificate::names_of(const support::IndexSet& set) const {
  std::string text = "{";
  const char* separator = "";
  for (const int candidate : set) {
    text += separator + names[static_cast<std::size_t>(candidate)];
    separator = " ";
  }
  return text + "}";
}

std::vector<std::size_t> Certificate::motions_of(const support::IndexSet& block) const {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < motions; ++k) {
    bool own = false;
    for (const int candidate : block) {
      const auto first = dimension * static_cast<std::size_t>(candidate);
      for (std::size_t row = first; row < first + dimension; ++row)
        own = own || motion_values[motions * row + k] != 0;
    }
    if (own) columns.push_back(k);
  }
  return columns;
}

Certificate read_certificate(std::string_view text, const std::string& file) {
  auto lines = lines_after(contact_first_line, text, file);
  Certificate certificate;
  read_header(lines, certificate);
  read_blocks(lines, certificate);
  read_stiffness(lines, certificate);
  read_motions(lines, certificate);
  read_loads(lines, certificate);
  read_theorems(lines, certificate);
  read_bounds(lines, certificate);
  read_evidence(lines, certificate);
  return certificate;
}

}  // namespace kusabi::verify
