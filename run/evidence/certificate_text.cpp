// Lines of a certificate, with all digits of numbers.
#include <string_view>

#include <fmt/format.h>

#include "problems/wedged/free_stiffness.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/evidence/certificate_file.hpp"
#include "support/sha1.hpp"

namespace kusabi::run {
std::string one_line(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    text += control ? fmt::format("\\x{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return text;
}

namespace {

template <class Numbers>
void append(std::string& text, const Numbers& numbers) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(text), " {:a}", number);
}

void append_bound(std::string& text, const wedged::ProvedBound& bound) {
  const auto* const side = bound.side == wedged::Side::contact ? "contact" : "separated";
  const auto* const kind = bound.excludes_side() ? "never" : "bound";
  text += fmt::format("{} {} {} {}", kind, bound.block + 1, bound.candidate, side);
  if (!bound.excludes_side()) text += fmt::format(" {:a}", bound.maximum);
  append(text, bound.numbers);
  text += '\n';
}

const char* kind_name(wedged::Evidence::Kind kind) {
  using Kind = wedged::Evidence::Kind;
  switch (kind) {
    case Kind::infeasible:
      return "dead";
    case Kind::cut:
      return "cut";
    case Kind::form:
      return "form";
    case Kind::feasible:
      return "alive";
    case Kind::no_claim:
      break;
  }
  return "marginal";
}

}  // namespace

void append_numbers(std::string& text, std::span<const double> numbers) {
  append(text, numbers);
}

std::string candidate_lines(const problems::WedgedProblem& problem,
                            std::span<const double> friction) {
  auto text =
      fmt::format("dimension {}\ncandidates {}\n", problem.dimension, problem.contact_names.size());
  for (const auto& name : problem.contact_names) text += fmt::format("name {}\n", one_line(name));
  text += "friction";
  append(text, friction);
  const auto blocks = problems::blocks_of(problem);
  text += fmt::format("\nblocks {}\n", blocks.size());
  for (const auto& block : blocks) text += fmt::format("block {}\n", support::hexadecimal(block));
  return text;
}

std::string motion_lines(const problems::WedgedProblem& problem) {
  const auto& motions = problem.modes.matrix;
  auto text = fmt::format("motions {}\n", motions.cols());
  for (Eigen::Index i = 0; i < motions.rows() && motions.cols() > 0; ++i) {
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      text += fmt::format("{}{:a}", k == 0 ? "" : " ", motions(i, k));
    text += '\n';
  }
  return text;
}

std::string certificate_header(const problems::WedgedProblem& problem,
                               std::span<const double> friction,
                               std::span<const wedged::ProvedBound> bounds) {
  auto text = "kusabi certificate 4\n" + candidate_lines(problem, friction);
  text += "stiffness\n";
  const auto stiffness = problems::free_stiffness(problem);
  for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      text += fmt::format("{}{:a}", j == 0 ? "" : " ", stiffness(i, j));
    }
    text += '\n';
  }
  text += motion_lines(problem);
  text += fmt::format("bounds {}\n", bounds.size());
  for (const auto& bound : bounds) append_bound(text, bound);
  return text + "nodes\n";
}

std::string certificate_line(const wedged::Evidence& evidence) {
  auto line = fmt::format("{} {} {} {}", kind_name(evidence.kind), evidence.block + 1,
                          support::hexadecimal(evidence.node.contact),
                          support::hexadecimal(evidence.node.separated));
  append(line, evidence.numbers);
  return line + '\n';
}

}  // namespace kusabi::run
