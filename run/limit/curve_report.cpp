// List of curves.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include "problems/limit/half_widths.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/csv.hpp"
#include "run/pictures/limit_values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

/// A curve and its name in each view.
struct NamedCurve {
  const limit::LoadCurve* curve;
  const char* key;    // in JSON
  const char* name;   // in CSV
  const char* title;  // in the table
  const char* load;   // loads of the factors
  double size;        // of the load at beta = 1, for the column `load`
};

std::vector<NamedCurve> curves_of(const LimitReport& report) {
  const auto& parameters = report.options.parameters;
  const auto& answer = report.answer;
  const double alpha =
      problems::common_half_width(report.problem, parameters.alpha.value_or(0)).value_or(1);
  std::vector<NamedCurve> list;
  if (answer.curve)
    list.push_back(
        {&*answer.curve, "curve", "critical", "beta times the critical load", "this load", alpha});
  if (answer.worst_curve) {
    list.push_back({&*answer.worst_curve, "worst_curve", "worst", "worst case for beta times alpha",
                    "some admissible load", alpha});
  }
  if (answer.load_curve) {
    list.push_back({&*answer.load_curve, "load_curve", "load",
                    "beta times the load of --curve-load", "this load",
                    parameters.curve_load->cwiseAbs().maxCoeff()});
  }
  return list;
}

}  // namespace

std::string curves_text(const LimitReport& report) {
  std::string text;
  for (const auto& named : curves_of(report)) {
    text += fmt::format("\n{}{}\n", named.title, report.residual ? upper_values : "");
    text += named.curve->pieces.empty()
                ? "  not found\n"
                : curve_text(report.problem, *named.curve, "beta", named.load);
  }
  return text;
}

void add_curves(ordered_json& result, const LimitReport& report) {
  for (const auto& named : curves_of(report))
    add_curve(result, named.key, report.problem, *named.curve);
}

void write_curves_csv(std::ostream& out, const LimitReport& report) {
  out << "curve,beta,load,factor,error,along_reference_load,tension,compression\n";
  for (const auto& named : curves_of(report)) {
    const auto row = [&](double beta, const std::string& rest) {
      fmt::print(out, "{},{},{},{}\n", named.name, beta, beta * named.size, rest);
    };
    for (const auto& piece : named.curve->pieces) {
      const auto mode = named_mode(report.problem, piece.from.motion);
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
