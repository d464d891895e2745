// Text of certificates of trusses: the truss once, the loads of each load case once.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "support/one_line.hpp"
#include "support/sha1.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {
namespace {

/// Words and numbers of a line.
class LineWriter {
 public:
  LineWriter(std::string& text, std::string_view keyword) : text_(text) {
    text_ += '\n';
    text_ += keyword;
  }
  LineWriter& operator<<(std::string_view word) {
    text_ += ' ';
    text_ += word;
    return *this;
  }
  LineWriter& operator<<(std::size_t value) {
    return *this << std::string_view(std::to_string(value));
  }
  LineWriter& operator<<(double value) {
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value),
                                   std::chars_format::hex)
                         .ptr;
    text_ += value < 0 ? " -0x" : " 0x";
    text_.append(digits.data(), end);
    return *this;
  }
  LineWriter& operator<<(const std::vector<double>& numbers) {
    for (const double number : numbers) *this << number;
    return *this;
  }
  LineWriter& operator<<(const std::vector<std::size_t>& numbers) {
    *this << numbers.size();
    for (const auto number : numbers) *this << number;
    return *this;
  }
  LineWriter& operator<<(const Sparse& entries) {
    *this << entries.size();
    for (const auto& [place, value] : entries) *this << place << value;
    return *this;
  }

 private:
  std::string& text_;
};

void put_truss(std::string& text, const Structure& truss) {
  LineWriter(text, "dimension") << truss.dimension;
  LineWriter(text, "nodes") << truss.coordinates.size();
  for (std::size_t node = 0; node < truss.coordinates.size(); ++node) {
    LineWriter line(text, "node");
    for (std::size_t axis = 0; axis < truss.dimension; ++axis)
      line << truss.coordinates[node][axis] << (truss.fixed[node][axis] ? "fixed" : "free");
  }
  LineWriter(text, "members") << truss.bars.size();
  for (const auto& bar : truss.bars) {
    LineWriter(text, "member") << bar.first << bar.second << bar.tension << bar.compression
                               << bar.residual;
  }
}

void put_forces(std::string& text, std::string_view keyword, const Structure& truss,
                const std::vector<Force>& forces) {
  LineWriter(text, keyword) << forces.size();
  for (const auto& force : forces) {
    LineWriter line(text, "force");
    line << force.node;
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) line << force.components[axis];
  }
}

void put_case(std::string& text, const TrussTheorem& theorem) {
  const auto& truss = theorem.truss;
  LineWriter line(text, "case");
  if (!theorem.load_case.empty()) line << std::string_view(support::on_one_line(theorem.load_case));
  put_forces(text, "dead", truss, truss.dead);
  put_forces(text, "reference", truss, truss.reference);
  const auto& uncertain = *truss.uncertain;
  LineWriter(text, "uncertain") << uncertain.size();
  for (std::size_t j = 0; j < uncertain.size(); ++j) {
    LineWriter column(text, "column");
    column << *truss.half_widths[j] << uncertain[j].size();
    for (const auto& each : uncertain[j]) column << each.node << each.axis << each.weight;
    if (!truss.load_names[j].empty())
      column << std::string_view(support::on_one_line(truss.load_names[j]));
  }
}

void put_lower(std::string& text, const TrussTheorem& theorem) {
  if (theorem.losses == 0) {
    LineWriter(text, "cuts") << theorem.cuts.size();
    for (const auto& [column, factor, forces] : theorem.cuts)
      LineWriter(text, "cut") << column << factor << forces;
    LineWriter(text, "nodes") << theorem.nodes.size();
    for (const auto& node : theorem.nodes) {
      LineWriter line(text, "node");
      line << node.signs.size() - static_cast<std::size_t>(std::ranges::count(node.signs, 0));
      for (std::size_t j = 0; j < node.signs.size(); ++j) {
        if (node.signs[j] != 0) line << j << (node.signs[j] > 0 ? "+" : "-") << node.one_sided[j];
      }
      line << node.shares << node.factor << node.forces;
    }
    return;
  }
  LineWriter states(text, "states");
  states << theorem.states.size();
  if (!theorem.states.empty()) states << theorem.lower;
  for (const auto& state : theorem.states) {
    LineWriter(text, "state") << state.support;
    for (const auto& [factor, forces] : state.columns)
      LineWriter(text, "forces") << factor << forces;
  }
}

}  // namespace

std::string truss_certificate_text(std::span<const TrussTheorem> theorems) {
  std::string text(truss_first_line);
  put_truss(text, theorems.front().truss);
  std::vector<const TrussTheorem*> cases;  // the first theorem of each
  for (const auto& theorem : theorems) {
    if (cases.empty() || theorem.load_case != cases.back()->load_case) cases.push_back(&theorem);
  }
  LineWriter(text, "cases") << cases.size();
  for (const auto* const first : cases) put_case(text, *first);
  LineWriter(text, "theorems") << theorems.size();
  std::size_t number = 0;  // of the load case
  for (const auto& theorem : theorems) {
    if (number < cases.size() && &theorem == cases[number]) ++number;
    LineWriter(text, "theorem") << number << claim_word(theorem.claim)
                                << (theorem.residual ? "residual" : "strength") << theorem.losses
                                << theorem.sudden << theorem.kept;
    LineWriter(text, "lost") << theorem.collapse.lost;
    LineWriter(text, "load") << theorem.collapse.load;
    LineWriter(text, "motion") << theorem.collapse.motion;
    if (theorem.claim != LimitClaim::none) put_lower(text, theorem);
  }
  text += "\nend\n";
  text += "digest " + support::hexadecimal(support::sha1(text)) + "\n";
  return text;
}

}  // namespace kusabi::verify
