// Text of certificates of the loss of members: the truss once, then each load case.
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "support/one_line.hpp"
#include "support/sha1.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/loss_certificate.hpp"

namespace kusabi::verify {
namespace {

/// Words and numbers of a line.
class LineWriter {
 public:
  explicit LineWriter(std::string& text, std::string_view keyword) : text_(text) {
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
  LineWriter& operator<<(const std::vector<std::size_t>& numbers) {
    *this << numbers.size();
    for (const auto number : numbers) *this << number;
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
  for (const auto& bar : truss.bars)
    LineWriter(text, "member") << bar.first << bar.second << bar.tension << bar.compression;
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

void put_loads(std::string& text, const Structure& truss) {
  put_forces(text, "dead", truss, truss.dead);
  put_forces(text, "reference", truss, truss.reference);
  const auto& uncertain = *truss.uncertain;
  LineWriter(text, "uncertain") << uncertain.size();
  for (std::size_t j = 0; j < uncertain.size(); ++j) {
    LineWriter line(text, "column");
    line << *truss.half_widths[j] << uncertain[j].size();
    for (const auto& each : uncertain[j]) line << each.node << each.axis << each.weight;
    if (!truss.load_names[j].empty())
      line << std::string_view(support::on_one_line(truss.load_names[j]));
  }
}

void put_claim(std::string& text, const LossStatement& statement) {
  LineWriter(text, "lose") << statement.maximum << statement.sudden;
  LineWriter(text, "kept") << statement.kept;
  LineWriter lost(text, "lost");
  lost << statement.lost;
  if (statement.fatal) lost << "fatal";
  LineWriter load(text, "load");
  for (const double zeta : statement.load) load << zeta;
  LineWriter motion(text, "motion");
  for (const double u : statement.motion) motion << u;
  LineWriter lower(text, "lower");
  if (statement.lower) lower << *statement.lower;
  LineWriter(text, "states") << statement.states.size();
  for (const auto& state : statement.states) {
    LineWriter(text, "state") << state.support;
    for (const auto& column : state.columns) {
      LineWriter line(text, "forces");
      line << column.factor << column.forces.size();
      for (const auto& [member, force] : column.forces) line << member << force;
    }
  }
}

}  // namespace

std::string loss_certificate_text(std::span<const LossStatement> statements) {
  std::string text(loss_first_line);
  put_truss(text, statements.front().truss);
  for (const auto& statement : statements) {
    if (statement.residual) {
      LineWriter strengths(text, "residual");
      for (const auto& bar : statement.truss.bars) strengths << bar.compression;
    } else {
      text += "\ncase";
      if (!statement.load_case.empty()) text += ' ' + support::on_one_line(statement.load_case);
      put_loads(text, statement.truss);
    }
    put_claim(text, statement);
  }
  text += "\nend\n";
  text += "digest " + support::hexadecimal(support::sha1(text)) + "\n";
  return text;
}

}  // namespace kusabi::verify
