// Text of limit-load certificates: the truss once, each load case once.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include "support/one_line.hpp"
#include "support/sha1.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {
namespace {

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

// One number if all are equal.
void put_half_widths(std::string& text, const std::vector<double>& alpha) {
  if (std::ranges::adjacent_find(alpha, std::not_equal_to()) != alpha.end()) {
    put(text, alpha);
  } else {
    put(text, alpha.empty() ? 0.0 : alpha.front());
  }
}

void put_truss(std::string& text, const LimitCertificate& truss) {
  text += "\ndisplacements " + std::to_string(truss.displacements);
  text += "\nmembers " + std::to_string(truss.members());
  for (std::size_t i = 0; i < truss.members(); ++i) {
    text += "\nmember";
    put(text, truss.tension[i]);
    put(text, truss.compression[i]);
    put(text, truss.columns[i]);
  }
}

void put_loads(std::string& text, const LimitStatement& statement) {
  const auto& loads = statement.evidence;
  text += "\ncase";
  if (!statement.load_case.empty()) text += ' ' + support::on_one_line(statement.load_case);
  text += "\ndead";
  put(text, loads.dead);
  text += "\nreference";
  for (const double value : loads.reference)
    put(text, statement.claim == LimitClaim::minimum ? -value : value);
  text += "\nuncertain " + std::to_string(loads.uncertain.size());
  for (const auto& column : loads.uncertain) {
    text += "\ncolumn";
    for (const auto& [at, value] : column) {
      put(text, at);
      put(text, value);
    }
  }
  const auto unnamed = std::ranges::count(loads.names, std::string());
  text += "\nnames " + std::to_string(std::ssize(loads.names) - unnamed);
  for (std::size_t j = 0; j < loads.names.size(); ++j) {
    if (loads.names[j].empty()) continue;
    text += "\nname";
    put(text, j);
    text += ' ' + support::on_one_line(loads.names[j]);
  }
  text += "\nalpha";
  put_half_widths(text, loads.alpha);
}

void put_node(std::string& text, const LimitNode& node) {
  text += "\nnode";
  put(text, node.signs.size() - static_cast<std::size_t>(std::ranges::count(node.signs, 0)));
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

void put_evidence(std::string& text, const LimitCertificate& evidence) {
  text += "\nload";
  put(text, evidence.load);
  text += "\nmotion";
  put(text, evidence.motion);
  text += "\ncuts " + std::to_string(evidence.cuts.size());
  for (const auto& cut : evidence.cuts) {
    text += "\ncut";
    put(text, cut.column);
    put(text, cut.factor);
    put(text, cut.forces);
  }
  text += "\nnodes " + std::to_string(evidence.nodes.size());
  for (const auto& node : evidence.nodes) put_node(text, node);
}

}  // namespace

std::string limit_certificate_text(std::span<const LimitStatement> statements) {
  std::string text(limit_first_line);
  put_truss(text, statements.front().evidence);
  for (std::size_t first = 0; first < statements.size();) {
    put_loads(text, statements[first]);
    const auto& name = statements[first].load_case;
    bool residual = false;
    do {
      const auto& [load_case, claim, evidence, after_buckling] = statements[first];
      if (after_buckling && !residual) {
        text += "\nresidual";
        put(text, evidence.compression);
      }
      residual = after_buckling;
      text += "\nclaim ";
      text += claim_word(claim);
      put_evidence(text, evidence);
      ++first;
    } while (first < statements.size() && statements[first].load_case == name);
  }
  text += "\nend\n";
  text += "digest " + support::hexadecimal(support::sha1(text)) + "\n";
  return text;
}

}  // namespace kusabi::verify
