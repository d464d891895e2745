// Lines of candidate bounds in a certificate.
#include <algorithm>
#include <span>
#include <string>

#include "verify/wedged/certificate_lines.hpp"

namespace kusabi::verify {
namespace {

Side read_side(Lines& lines) {
  const auto word = lines.word();
  if (word == side_name(Side::contact)) return Side::contact;
  if (word != side_name(Side::separated)) lines.refuse("'contact' or 'separated'");
  return Side::separated;
}

CandidateBound read_bound(Lines& lines, const Certificate& certificate) {
  lines.next();
  const auto keyword = lines.word();
  const bool never = keyword == "never";
  if (!never && keyword != "bound") lines.refuse("'bound' or 'never'");
  CandidateBound bound;
  bound.line = lines.number();
  bound.theorem = read_theorem_number(lines, certificate);
  const auto& theorem = certificate.theorems[bound.theorem];
  refuse_without_weights(lines, theorem);
  const auto& block = certificate.blocks[theorem.block];
  const std::string candidate = "a contact candidate of the block, counted from 0";
  const auto number = lines.integer(10, candidate);
  if (number >= certificate.candidates()) lines.refuse(candidate);
  bound.candidate = static_cast<int>(number);
  if (!block.contains(bound.candidate)) lines.refuse(candidate);
  bound.side = read_side(lines);
  const std::string above_zero = "a bound above zero";
  if (!never) bound.maximum = lines.number(above_zero);
  if (bound.maximum && *bound.maximum <= 0) lines.refuse(above_zero);
  const auto own = static_cast<std::size_t>(block.size());
  const auto moving = certificate.motions_of(block).size();
  const auto first = own + moving + (theorem.grip ? 1 : 0);
  lines.numbers(first + own + (never ? 0 : 1), bound.numbers, multipliers_of(moving));
  refuse_negative(lines, std::span(bound.numbers).subspan(first, own));
  if (!never && bound.numbers.back() <= 0) {
    lines.refuse("the multiplier of the opposite of the bound, the last one, above zero");
  }
  return bound;
}

}  // namespace

const char* side_name(Side side) {
  return side == Side::contact ? "contact" : "separated";
}

std::string multipliers_of(std::size_t motions) {
  return motions > 0 ? "multipliers and parts of motions" : "multipliers";
}

void refuse_negative(const Lines& lines, std::span<const double> multipliers) {
  if (std::any_of(multipliers.begin(), multipliers.end(), [](double eta) { return eta < 0; })) {
    lines.refuse("multipliers of cuts that are not negative");
  }
}

void read_bounds(Lines& lines, Certificate& certificate) {
  for (auto left = lines.count("bounds"); left > 0; --left)
    certificate.bounds.push_back(read_bound(lines, certificate));
}

}  // namespace kusabi::verify
