// Reader of certificates of states under load.
#include "verify/wedged/hold_certificate.hpp"

#include <algorithm>
#include <tuple>

#include "verify/wedged/certificate_lines.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {
namespace {

constexpr std::string_view only_version = "kusabi hold certificate 1";

LoadShare read_share(Lines& lines) {
  const std::string what = "two factors, of the dead load (0 or 1) and of the reference load";
  LoadShare share;
  share.dead = lines.number(what);
  share.reference = lines.number(what);
  if (share.dead != 0 && share.dead != 1) lines.refuse(what);
  return share;
}

HoldTree read_tree(Lines& lines, const Certificate& header, const std::optional<double>& total) {
  HoldTree tree;
  tree.line = lines.number();
  tree.block = read_block_number(lines, header);
  const std::string count = "the number of its loads, 0, 1 or 2";
  const auto shares = lines.integer(10, count);
  if (shares > 2) lines.refuse(count);
  for (std::uint64_t j = 0; j < shares; ++j) tree.shares.push_back(read_share(lines));
  if (total) {
    tree.grip = GripBound{GripBound::Kind::equal, *total};
    lines.end_of_line("no further word");
    return tree;
  }
  if (lines.remainder().empty()) return tree;
  const std::string what = "'above' or 'below', and a sum of normal reactions";
  const auto kind = lines.word();
  if (kind != "above" && kind != "below") lines.refuse(what);
  tree.grip = GripBound{kind == "above" ? GripBound::Kind::above : GripBound::Kind::below,
                        lines.number(what)};
  if (tree.grip->total < 0) lines.refuse("a sum that is not negative");
  lines.end_of_line(what);
  return tree;
}

void read_trees(Lines& lines, HoldCertificate& certificate) {
  lines.next();
  const std::string trees = "'trees' and how many there are";
  if (lines.text().starts_with("total ")) {
    const std::string total = "'total' and a force above zero";
    lines.expect_word("total", total);
    certificate.total = lines.number(total);
    if (*certificate.total <= 0) lines.refuse(total);
    if (certificate.header.blocks.size() != 1)
      lines.refuse("no total, since it is that of one block");
    lines.end_of_line(total);
    lines.next();
  }
  lines.expect_word("trees", trees);
  const auto count = lines.integer(10, trees);
  if (count > lines.left()) lines.refuse(trees);
  lines.end_of_line(trees);
  for (std::uint64_t t = 0; t < count; ++t) {
    lines.next();
    lines.expect_word("tree", "'tree' and its block, loads and sum");
    certificate.trees.push_back(read_tree(lines, certificate.header, certificate.total));
  }
}

// Two disjoint sets of candidates of a block. @param whole all of its candidates
void read_sets(Lines& lines, const support::IndexSet& block, bool whole, support::IndexSet& contact,
               support::IndexSet& separated) {
  const std::string sets = "two disjoint sets of candidates of the block, in hexadecimal digits";
  contact = lines.set(sets);
  separated = lines.set(sets);
  const auto known = contact | separated;
  if (contact.meets(separated) || !block.includes(known)) lines.refuse(sets);
  if (whole && known != block)
    lines.refuse("a leaf: every contact candidate in one of the two sets");
}

HoldNode read_node(Lines& lines, const HoldCertificate& certificate) {
  HoldNode node;
  const auto what = "the number of a tree, from 1 to " + std::to_string(certificate.trees.size());
  const auto number = lines.integer(10, what);
  if (number < 1 || number > certificate.trees.size()) lines.refuse(what);
  node.tree = number - 1;
  const auto& tree = certificate.trees[node.tree];
  const auto& block = certificate.header.blocks[tree.block];
  auto& record = node.record;
  record.line = lines.number();
  record.claim = Claim::infeasible;
  record.block = tree.block;
  read_sets(lines, block, false, record.contact, record.separated);
  const auto moving = certificate.header.motions_of(block).size();
  lines.numbers(static_cast<std::size_t>(block.size()) + moving + (tree.grip ? 1 : 0),
                record.numbers, multipliers_of(moving));
  return node;
}

HoldState read_state(Lines& lines, bool wedged, const HoldCertificate& certificate) {
  const auto& header = certificate.header;
  HoldState state;
  state.line = lines.number();
  state.block = read_block_number(lines, header);
  if (!wedged) state.share = read_share(lines);
  const auto& block = header.blocks[state.block];
  read_sets(lines, block, true, state.contact, state.separated);
  const auto touching = static_cast<std::size_t>(state.contact.size());
  lines.numbers((header.dimension - 1) * touching + header.motions_of(block).size(), state.numbers,
                "tangential reactions and parts of motions");
  return state;
}

void read_nodes(Lines& lines, HoldCertificate& certificate) {
  lines.expect("nodes");
  for (std::size_t count = 0;; ++count) {
    lines.next();
    const auto keyword = lines.word();
    if (keyword == "dead") {
      certificate.nodes.push_back(read_node(lines, certificate));
    } else if (keyword == "alive" || keyword == "wedged") {
      certificate.states.push_back(read_state(lines, keyword == "wedged", certificate));
    } else if (keyword == "end") {
      lines.expect_node_count(count);
      lines.expect_end();
      return;
    } else {
      lines.refuse("'dead', 'alive', 'wedged' or 'end'");
    }
  }
}

}  // namespace

HoldCertificate read_hold_certificate(std::string_view text, const std::string& file) {
  Lines beginning(text, file);
  beginning.next();
  if (beginning.text() != only_version) beginning.refuse("'" + std::string(only_version) + "'");
  Lines lines(without_digest(text, file), file);
  lines.next();
  HoldCertificate certificate;
  lines.next();
  lines.expect_word("case", "'case' and the name of a load case, or none");
  certificate.load_case = lines.remainder();
  read_header(lines, certificate.header);
  read_blocks(lines, certificate.header);
  read_motions(lines, certificate.header);
  read_trees(lines, certificate);
  read_nodes(lines, certificate);
  return certificate;
}

}  // namespace kusabi::verify
