// Reader of certificates: the header. Bounds and nodes have files of their own.
#include "verify/wedged/certificate.hpp"

#include <algorithm>
#include <map>

#include "verify/wedged/certificate_lines.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

// Larger counts exceed any search; K would have more than 10^8 entries.
constexpr std::size_t max_candidates = 4096;
constexpr std::string_view first_line = "kusabi certificate 1";
constexpr std::string_view second_version = "kusabi certificate 2";
constexpr std::string_view third_version = "kusabi certificate 3";
constexpr std::string_view fourth_version = "kusabi certificate 4";

void read_names(Lines& lines, std::size_t count, Certificate& certificate) {
  std::map<std::string_view, std::size_t> lines_of;  // names are views of the text
  for (std::size_t i = 0; i < count; ++i) {
    lines.next();
    lines.expect_word("name", "'name' and the name of contact candidate " + std::to_string(i + 1));
    const auto name = lines.remainder();
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

}  // namespace

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
  // Checked first, since a file of another kind is not to be reported as damaged.
  Lines beginning(text, file);
  beginning.next();
  const bool fourth = beginning.text() == fourth_version;
  const bool third = fourth || beginning.text() == third_version;
  const Version version{.names_blocks = third || beginning.text() == second_version,
                        .has_motions = third,
                        .has_bounds = fourth};
  if (!version.names_blocks && beginning.text() != first_line) {
    beginning.refuse("'" + std::string(fourth_version) + "'");
  }
  Lines lines(without_digest(text, file), file);
  lines.next();
  Certificate certificate;
  read_header(lines, certificate);
  if (version.names_blocks) {
    read_blocks(lines, certificate);
  } else {
    certificate.blocks = {certificate.all_candidates()};
  }
  read_stiffness(lines, certificate);
  if (version.has_motions) read_motions(lines, certificate);
  if (version.has_bounds) read_bounds(lines, certificate);
  read_records(lines, version, certificate);
  return certificate;
}

}  // namespace kusabi::verify
