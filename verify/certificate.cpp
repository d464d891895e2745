// The reader: line by line, word by word.
#include "verify/certificate.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "verify/lines.hpp"

namespace kusabi::verify {
namespace {

constexpr std::size_t most_candidates = 64;
constexpr std::string_view first_line = "kusabi certificate 1";

void read_header(Lines& lines, Certificate& certificate) {
  lines.expect(first_line);
  lines.next();
  const std::string dimension = "'dimension 2' or 'dimension 3'";
  lines.expect_word("dimension", dimension);
  certificate.dimension = lines.integer(10, dimension);
  if (certificate.dimension != 2 && certificate.dimension != 3) lines.refuse(dimension);
  lines.next();
  const std::string candidates = "'candidates' and a number from 1 to 64";
  lines.expect_word("candidates", candidates);
  const auto m = lines.integer(10, candidates);
  if (m < 1 || m > most_candidates) lines.refuse(candidates);
  for (std::size_t i = 0; i < m; ++i) {
    lines.next();
    lines.expect_word("name", "'name' and the name of contact candidate " + std::to_string(i + 1));
    certificate.names.emplace_back(lines.remainder());
  }
  lines.next();
  lines.expect_word("friction", "'friction' and a coefficient for each contact candidate");
  lines.numbers(m, certificate.friction, "friction coefficients");
  if (*std::min_element(certificate.friction.begin(), certificate.friction.end()) <= 0) {
    lines.refuse("friction coefficients above 0");
  }
}

void read_stiffness(Lines& lines, Certificate& certificate) {
  lines.expect("stiffness");
  const auto size = certificate.displacements();
  certificate.stiffness.resize(size * size);
  std::vector<double> row;
  for (std::size_t i = 0; i < size; ++i) {
    lines.next();
    row.clear();
    lines.numbers(i + 1, row, "entries of row " + std::to_string(i + 1) + " of the stiffness");
    for (std::size_t j = 0; j <= i; ++j) {
      certificate.stiffness[size * i + j] = certificate.stiffness[size * j + i] = row[j];
    }
  }
}

Record read_record(Lines& lines, Claim claim, const Certificate& certificate) {
  Record record;
  record.line = lines.number();
  record.claim = claim;
  const std::string sets = "two disjoint sets of the contact candidates, in hexadecimal digits";
  record.contact = lines.integer(16, sets);
  record.separated = lines.integer(16, sets);
  const auto known = record.contact | record.separated;
  if ((record.contact & record.separated) != 0 || (known & ~certificate.all_candidates()) != 0) {
    lines.refuse(sets);
  }
  if (claim != Claim::dead && known != certificate.all_candidates()) {
    lines.refuse("a leaf: every contact candidate in one of the two sets");
  }
  const auto touching = static_cast<std::size_t>(std::popcount(record.contact));
  switch (claim) {
    case Claim::dead:
      lines.numbers(certificate.candidates(), record.numbers, "multipliers");
      break;
    case Claim::alive:
      lines.numbers((certificate.dimension - 1) * touching, record.numbers, "tangential reactions");
      break;
    case Claim::marginal:
      lines.numbers(0, record.numbers, "numbers");
      break;
  }
  return record;
}

void read_records(Lines& lines, Certificate& certificate) {
  lines.expect("nodes");
  for (std::size_t count = 0;; ++count) {
    lines.next();
    const auto keyword = lines.word();
    if (keyword == "end") {
      const auto expected = "'end " + std::to_string(count) + "', the number of nodes above";
      if (lines.integer(10, expected) != count || !lines.remainder().empty()) {
        lines.refuse(expected);
      }
      if (!lines.done()) {
        lines.next();
        lines.refuse("the line 'digest …', the last one");
      }
      return;
    }
    const auto claims = {Claim::dead, Claim::alive, Claim::marginal};
    const auto* const claim = std::find_if(claims.begin(), claims.end(),
                                           [&](Claim one) { return keyword == claim_name(one); });
    if (claim == claims.end()) lines.refuse("'dead', 'alive', 'marginal' or 'end'");
    certificate.records.push_back(read_record(lines, *claim, certificate));
  }
}

// A search that went on from a checkpoint closes some nodes again, with the same evidence.
void leave_out_repeated(std::vector<Record>& records) {
  const auto key = [](const Record& record) {
    return std::tuple(record.contact, record.separated, record.claim);
  };
  const auto place = [](const Record& record) { return record.line; };
  std::stable_sort(records.begin(), records.end(),
                   [&](const Record& a, const Record& b) { return key(a) < key(b); });
  const auto same = [&](const Record& a, const Record& b) { return key(a) == key(b); };
  records.erase(std::unique(records.begin(), records.end(), same), records.end());
  std::sort(records.begin(), records.end(),
            [&](const Record& a, const Record& b) { return place(a) < place(b); });
}

}  // namespace

const char* claim_name(Claim claim) {
  switch (claim) {
    case Claim::dead:
      return "dead";
    case Claim::alive:
      return "alive";
    default:
      return "marginal";
  }
}

std::string Certificate::names_of(std::uint64_t set) const {
  std::string text = "{";
  const char* separator = "";
  for (; set != 0; set &= set - 1) {
    text += separator + names[static_cast<std::size_t>(std::countr_zero(set))];
    separator = " ";
  }
  return text + "}";
}

Certificate read_certificate(std::string_view text, const std::string& file) {
  // Something else altogether is not called damaged.
  Lines(text, file).expect(first_line);
  Lines lines(without_digest(text, file), file);
  Certificate certificate;
  read_header(lines, certificate);
  read_stiffness(lines, certificate);
  read_records(lines, certificate);
  leave_out_repeated(certificate.records);
  return certificate;
}

}  // namespace kusabi::verify
