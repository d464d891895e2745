// Lines of theorems, of the closed nodes of their trees, and of states.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "verify/wedged/certificate_lines.hpp"

namespace kusabi::verify {
namespace {

LoadShare read_share(Lines& lines) {
  const std::string what =
      "two factors, of the dead load (0 or 1) and of the reference load, not both zero";
  LoadShare share;
  share.dead = lines.number(what);
  share.reference = lines.number(what);
  if (share.dead != 0 && share.dead != 1) lines.refuse(what);
  if (share == LoadShare{}) lines.refuse(what);
  return share;
}

// 'above S' or 'below S', if the line has more words.
std::optional<GripBound> read_grip(Lines& lines) {
  if (lines.remainder().empty()) return {};
  const std::string what = "'above' or 'below', and a sum of normal reactions";
  const auto kind = lines.word();
  if (kind != "above" && kind != "below") lines.refuse(what);
  const GripBound grip{kind == "above" ? GripBound::Kind::above : GripBound::Kind::below,
                       lines.number(what)};
  if (grip.total < 0) lines.refuse("a sum that is not negative");
  return grip;
}

// True for 'except dead', of a cone with the dead load at its border, so that the factors of the
// others are one range.
bool read_exception(Lines& lines, const std::vector<LoadShare>& shares) {
  if (lines.remainder() != "except dead") return false;
  constexpr LoadShare dead{1, 0};
  if (shares.size() != 2 || (shares[0] == dead) == (shares[1] == dead))
    lines.refuse("the dead load and another load, if the dead load alone is excepted");
  lines.word();
  lines.word();
  return true;
}

// 'weights' and a positive number for each load, if these are the next words.
std::vector<double> read_weights(Lines& lines, std::size_t count) {
  constexpr std::string_view keyword = "weights ";
  if (!lines.remainder().starts_with(keyword)) return {};
  const std::string what = "'weights' and a number above zero for each load";
  lines.word();
  std::vector<double> weights;
  for (std::size_t j = 0; j < count; ++j) weights.push_back(lines.number(what));
  if (std::ranges::min(weights) <= 0) lines.refuse(what);
  return weights;
}

Theorem read_theorem(Lines& lines, const Certificate& certificate) {
  lines.next();
  lines.expect_word("none", "'none' with its block, loads and sum");
  Theorem theorem;
  theorem.line = lines.number();
  theorem.block = read_block_number(lines, certificate);
  const std::string count = "the number of its loads, 0, 1 or 2";
  const auto shares = lines.integer(10, count);
  if (shares > (certificate.loads ? 2U : 0U))
    lines.refuse(certificate.loads ? count : "no loads, since the certificate has none");
  for (std::uint64_t j = 0; j < shares; ++j) theorem.shares.push_back(read_share(lines));
  if (theorem.about_wedged()) {
    lines.end_of_line("no sum without loads");
    return theorem;
  }
  theorem.weights = read_weights(lines, theorem.shares.size());
  theorem.except_dead = read_exception(lines, theorem.shares);
  if (certificate.total)
    theorem.grip = GripBound{GripBound::Kind::equal, *certificate.total};
  else
    theorem.grip = read_grip(lines);  // none is left after an exception
  lines.end_of_line("no further word");
  return theorem;
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

Node read_node(Lines& lines, Claim claim, const Certificate& certificate) {
  Node node;
  node.line = lines.number();
  node.claim = claim;
  node.theorem = read_theorem_number(lines, certificate);
  const auto& theorem = certificate.theorems[node.theorem];
  const auto& block = certificate.blocks[theorem.block];
  if (claim == Claim::form && !theorem.about_wedged())
    lines.refuse("the number of a theorem without loads, since forms are about these");
  if (claim == Claim::cut) refuse_without_weights(lines, theorem);
  read_sets(lines, block, false, node.contact, node.separated);
  const auto moving = certificate.motions_of(block).size();
  const auto own = static_cast<std::size_t>(block.size());
  const auto without_cuts = own + moving + (theorem.grip ? 1 : 0);
  switch (claim) {
    case Claim::infeasible:
      lines.numbers(without_cuts, node.numbers, multipliers_of(moving));
      break;
    case Claim::cut:
      lines.numbers(without_cuts + own, node.numbers, multipliers_of(moving));
      refuse_negative(lines, std::span(node.numbers).subspan(without_cuts));
      break;
    case Claim::form:
      if (!(node.contact | node.separated).empty()) lines.refuse("two empty sets, '0 0'");
      lines.numbers((certificate.dimension + (moving > 0 ? 1 : 0)) * own * own + own, node.numbers,
                    "multipliers of products, slips and squares");
      break;
    case Claim::none:
      lines.numbers(0, node.numbers, "numbers");
      break;
  }
  return node;
}

State read_state(Lines& lines, bool wedged, const Certificate& certificate) {
  State state;
  state.line = lines.number();
  state.block = read_block_number(lines, certificate);
  if (!wedged && !certificate.loads) lines.refuse("'wedged', since the certificate has no loads");
  if (!wedged) state.share = read_share(lines);
  const auto& block = certificate.blocks[state.block];
  read_sets(lines, block, true, state.contact, state.separated);
  const auto touching = static_cast<std::size_t>(state.contact.size());
  const auto moving = certificate.motions_of(block).size();
  lines.numbers((certificate.dimension - 1) * touching + moving, state.numbers,
                moving > 0 ? "tangential reactions and parts of motions" : "tangential reactions");
  return state;
}

// Keeps the first of several items with the same key. A search resumed from a checkpoint closes
// some nodes again, with the same evidence.
template <class Item, class Key>
void leave_out_repeated(std::vector<Item>& items, Key key) {
  std::ranges::stable_sort(items, {}, key);
  const auto same = [&](const Item& a, const Item& b) { return key(a) == key(b); };
  items.erase(std::unique(items.begin(), items.end(), same), items.end());
  std::ranges::sort(items, {}, &Item::line);
}

}  // namespace

const char* claim_name(Claim claim) {
  switch (claim) {
    case Claim::infeasible:
      return "infeasible";
    case Claim::cut:
      return "cut";
    case Claim::form:
      return "form";
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

std::size_t read_theorem_number(Lines& lines, const Certificate& certificate) {
  const auto what =
      "the number of a theorem, from 1 to " + std::to_string(certificate.theorems.size());
  const auto number = lines.integer(10, what);
  if (number < 1 || number > certificate.theorems.size()) lines.refuse(what);
  return number - 1;
}

void refuse_without_weights(const Lines& lines, const Theorem& theorem) {
  if (!theorem.may_have_bounds())
    lines.refuse("the number of a theorem without loads, or with their weights");
}

void read_theorems(Lines& lines, Certificate& certificate) {
  for (auto left = lines.count("theorems"); left > 0; --left)
    certificate.theorems.push_back(read_theorem(lines, certificate));
}

void read_evidence(Lines& lines, Certificate& certificate) {
  lines.expect("evidence");
  for (std::size_t count = 0;; ++count) {
    lines.next();
    const auto keyword = lines.word();
    if (keyword == "end") {
      lines.expect_node_count(count);
      lines.expect_end();
      break;
    }
    if (keyword == "wedged" || keyword == "held") {
      certificate.states.push_back(read_state(lines, keyword == "wedged", certificate));
      continue;
    }
    constexpr std::array claims{Claim::infeasible, Claim::cut, Claim::form, Claim::none};
    const auto* const claim =
        std::ranges::find_if(claims, [&](Claim one) { return keyword == claim_name(one); });
    if (claim == claims.end())
      lines.refuse("'infeasible', 'cut', 'form', 'marginal', 'wedged', 'held' or 'end'");
    certificate.nodes.push_back(read_node(lines, *claim, certificate));
  }
  leave_out_repeated(certificate.nodes, [](const Node& node) {  // all infeasible nodes are the same
    return std::tuple(node.theorem, node.contact, node.separated, node.claim == Claim::none);
  });
  // Several states under one load may have one pattern, with other sums of normal reactions.
  leave_out_repeated(certificate.states, [](const State& state) {
    return std::tuple(state.block, state.contact, state.separated, state.share,
                      state.share ? state.numbers : std::vector<double>());
  });
}

}  // namespace kusabi::verify
