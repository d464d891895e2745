// Lines of closed nodes in a certificate.
#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "verify/wedged/certificate_lines.hpp"

namespace kusabi::verify {
namespace {

Record read_record(Lines& lines, Claim claim, Version version, const Certificate& certificate) {
  Record record;
  record.line = lines.number();
  record.claim = claim;
  if (version.names_blocks) record.block = read_block_number(lines, certificate);
  const auto& block = certificate.blocks[record.block];
  const std::string sets =
      version.names_blocks ? "two disjoint sets of candidates of the block, in hexadecimal digits"
                           : "two disjoint sets of the contact candidates, in hexadecimal digits";
  record.contact = lines.set(sets);
  record.separated = lines.set(sets);
  const auto known = record.contact | record.separated;
  if (record.contact.meets(record.separated) || !block.includes(known)) lines.refuse(sets);
  const bool leaf = claim == Claim::feasible || (claim == Claim::none && !version.names_blocks);
  if (leaf && known != block) {
    lines.refuse("a leaf: every contact candidate in one of the two sets");
  }
  const auto touching = static_cast<std::size_t>(record.contact.size());
  const auto moving = certificate.motions_of(block).size();
  const auto own = static_cast<std::size_t>(block.size());
  switch (claim) {
    case Claim::infeasible:
      lines.numbers(own + moving, record.numbers, multipliers_of(moving));
      break;
    case Claim::cut:
      lines.numbers(2 * own + moving, record.numbers, multipliers_of(moving));
      refuse_negative(lines, std::span(record.numbers).subspan(own + moving));
      break;
    case Claim::form:
      if (!known.empty()) lines.refuse("two empty sets, '0 0'");
      lines.numbers((certificate.dimension + (moving > 0 ? 1 : 0)) * own * own + own,
                    record.numbers, "multipliers of products, slips and squares");
      break;
    case Claim::feasible:
      lines.numbers(
          (certificate.dimension - 1) * touching + moving, record.numbers,
          moving > 0 ? "tangential reactions and parts of motions" : "tangential reactions");
      break;
    case Claim::none:
      lines.numbers(0, record.numbers, "numbers");
      break;
  }
  return record;
}

// A search resumed from a checkpoint closes some nodes again, with the same evidence.
void leave_out_repeated(std::vector<Record>& records) {
  // All claims of infeasibility count as the same.
  const auto key = [](const Record& record) {
    const bool none = record.claim == Claim::cut || record.claim == Claim::form;
    return std::tuple(record.block, record.contact, record.separated,
                      none ? Claim::infeasible : record.claim);
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
    case Claim::infeasible:
      return "dead";
    case Claim::cut:
      return "cut";
    case Claim::form:
      return "form";
    case Claim::feasible:
      return "alive";
    default:
      return "marginal";
  }
}

std::size_t read_block_number(Lines& lines, const Certificate& certificate) {
  const auto what = "the number of a block, from 1 to " + std::to_string(certificate.blocks.size());
  const auto number = lines.integer(10, what);
  if (number < 1 || number > certificate.blocks.size()) lines.refuse(what);
  return number - 1;
}

void read_records(Lines& lines, Version version, Certificate& certificate) {
  lines.expect("nodes");
  for (std::size_t count = 0;; ++count) {
    lines.next();
    if (count == 0 && lines.text() == "one pattern") {
      certificate.one_pattern = true;
      lines.next();
    }
    const auto keyword = lines.word();
    if (keyword == "end") {
      lines.expect_node_count(count);
      lines.expect_end();
      break;
    }
    std::vector<Claim> claims{Claim::infeasible, Claim::feasible, Claim::none};
    if (version.has_bounds) claims.insert(claims.end(), {Claim::cut, Claim::form});
    const auto claim = std::find_if(claims.begin(), claims.end(),
                                    [&](Claim one) { return keyword == claim_name(one); });
    if (claim == claims.end()) {
      lines.refuse(version.has_bounds ? "'dead', 'cut', 'form', 'alive', 'marginal' or 'end'"
                                      : "'dead', 'alive', 'marginal' or 'end'");
    }
    certificate.records.push_back(read_record(lines, *claim, version, certificate));
  }
  leave_out_repeated(certificate.records);
}

}  // namespace kusabi::verify
