// List of curves, and the text of a piece in each view.
#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include "answer/fields.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/half_widths.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/csv.hpp"

namespace kusabi::run {
namespace {

using limit::CurvePiece;
using limit::LoadCurve;
using nlohmann::ordered_json;
using problems::LimitProblem;

/// A curve and its name in each view.
struct NamedCurve {
  const LoadCurve* curve;
  const char* key;    // in JSON
  const char* name;   // in CSV
  const char* title;  // in the table
  double load;        // size of the load at beta = 1, for the column `load`
};

std::vector<NamedCurve> curves_of(const CurveReport& report) {
  const auto& [options, problem, answer] = report;
  const double alpha =
      problems::common_half_width(problem, options.parameters.alpha.value_or(0)).value_or(1);
  std::vector<NamedCurve> list;
  if (answer.curve) {
    list.push_back({&*answer.curve, "curve", "critical", "beta times the critical load", alpha});
  }
  if (answer.worst_curve) {
    list.push_back(
        {&*answer.worst_curve, "worst_curve", "worst", "worst case for beta times alpha", alpha});
  }
  if (answer.load_curve) {
    list.push_back({&*answer.load_curve, "load_curve", "load",
                    "beta times the load of --curve-load",
                    options.parameters.curve_load->cwiseAbs().maxCoeff()});
  }
  return list;
}

/// A mode by the names of its members.
struct NamedMode {
  bool along_reference;
  std::vector<std::string> yielding;  // those in tension and those in compression
  std::vector<std::string> tension;
  std::vector<std::string> compression;
};

NamedMode named_mode(const LimitProblem& problem, const CurvePiece& piece) {
  const auto mode = problems::collapse_mode(problem, piece.from.motion);
  NamedMode result{mode.along_reference, {}, {}, {}};
  for (const auto& [member, elongation] : mode.yielding) {
    result.yielding.push_back(problems::member_name(problem, member));
    auto& list = elongation > 0 ? result.tension : result.compression;
    list.push_back(result.yielding.back());
  }
  return result;
}

void write_table(std::string& text, const LimitProblem& problem, const NamedCurve& named,
                 bool struts) {
  const auto out = std::back_inserter(text);
  const auto& curve = *named.curve;
  fmt::format_to(out, "\n{}{}\n", named.title, struts ? upper_values : "");
  if (curve.pieces.empty()) {
    text += "  not found\n";
    return;
  }
  text += "        beta       factor  collapse mode above this beta\n";
  double error = 0;
  for (const auto& piece : curve.pieces) {
    const auto mode = named_mode(problem, piece);
    fmt::format_to(out, "  {:>10.6f} {:>12.6f}  {} yielding{}\n", piece.from.at, piece.from.factor,
                   answer::counted(mode.yielding.size(), "member"),
                   mode.along_reference ? ", along the reference load" : "");
    if (!mode.tension.empty()) {
      fmt::format_to(out, "{:27}in tension:     {}\n", "", fmt::join(mode.tension, " "));
    }
    if (!mode.compression.empty()) {
      fmt::format_to(out, "{:27}in compression: {}\n", "", fmt::join(mode.compression, " "));
    }
    error = std::max(error, piece.error.value_or(error));
  }
  const auto& last = curve.pieces.back();
  fmt::format_to(out, "  {:>10.6f} {:>12.6f}\n", last.to, last.factor_at_end);
  if (curve.end) {
    fmt::format_to(out, "  {:>10.6f}     not carried at any factor from here on, {}\n",
                   curve.end->not_carried_at, answer::standing_word(curve.end->standing));
  }
}

ordered_json pieces_json(const LimitProblem& problem, const LoadCurve& curve) {
  auto pieces = ordered_json::array();
  for (const auto& piece : curve.pieces) {
    const auto mode = named_mode(problem, piece);
    pieces.push_back({{"from", piece.from.at},
                      {"to", piece.to},
                      {"factor_from", piece.from.factor},
                      {"factor_to", piece.factor_at_end},
                      {"error", answer::number_or_null(piece.error)},
                      {"along_reference_load", mode.along_reference},
                      {"yielding", mode.yielding},
                      {"tension", mode.tension}});
  }
  return pieces;
}

}  // namespace

std::string CurveReport::table() const {
  std::string text;
  const bool struts = std::ranges::any_of(
      problem.members, [](const auto& member) { return member.yield->residual.has_value(); });
  for (const auto& named : curves_of(*this)) write_table(text, problem, named, struts);
  return text;
}

void CurveReport::add_to(ordered_json& result) const {
  for (const auto& named : curves_of(*this)) {
    result[named.key] = pieces_json(problem, *named.curve);
    const auto& end = named.curve->end;
    if (!end) continue;
    result[std::string(named.key) + "_end"] = {{"carried_at", end->carried_at},
                                               {"not_carried_at", end->not_carried_at},
                                               {"standing", answer::name_of(end->standing)}};
  }
}

void CurveReport::write_csv(std::ostream& out) const {
  out << "curve,beta,load,factor,error,along_reference_load,tension,compression\n";
  for (const auto& named : curves_of(*this)) {
    const auto row = [&](double beta, const std::string& rest) {
      fmt::print(out, "{},{},{},{}\n", named.name, beta, beta * named.load, rest);
    };
    for (const auto& piece : named.curve->pieces) {
      const auto mode = named_mode(problem, piece);
      row(piece.from.at,
          fmt::format("{},{},{},{},{}", piece.from.factor,
                      piece.error ? fmt::format("{}", *piece.error) : "",
                      mode.along_reference ? 1 : 0,
                      csv_cell(fmt::format("{}", fmt::join(mode.tension, " "))),
                      csv_cell(fmt::format("{}", fmt::join(mode.compression, " ")))));
    }
    if (named.curve->pieces.empty()) continue;
    const auto& last = named.curve->pieces.back();
    row(last.to, fmt::format("{},,,,", last.factor_at_end));
    if (named.curve->end) row(named.curve->end->not_carried_at, ",,,,");
  }
}

}  // namespace kusabi::run
