// Results of limit loads that `limit` and `sweep --alpha` share: bounds, collapse modes, curves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/model/load_curve.hpp"
#include "problems/limit/limit_problem.hpp"

namespace kusabi::run {

/// "2.26027659894 ... 2.2602765995, proved": bounds of a factor with their standing, rounded
/// outwards.
std::string factor_text(const support::Bracket& factor);

/// "factors -2.634577 ... 1.882777 are carried under all admissible loads, proved": the known
/// bounds, without a line end. @param loads those of the interval
std::string interval_text(const limit::GuaranteedInterval& interval, std::string_view loads);

/// Statement on the design load at every stage of loading, without a line end.
std::string passed_text(const limit::GuaranteedInterval& interval);

/// `minimum` and `maximum`, the brackets of both ends (docs/result-files.md).
nlohmann::ordered_json interval_json(const limit::GuaranteedInterval& interval);

/// A collapse mode by the names of the members that yield.
struct NamedMode {
  std::size_t moving = 0;  ///< number of nodes
  bool along_reference = false;
  std::vector<std::string> yielding{};  ///< those in tension and those in compression
  std::vector<std::string> tension{};
  std::vector<std::string> compression{};
};

/// @param motion n^d
NamedMode named_mode(const problems::LimitProblem& problem, const Eigen::VectorXd& motion);

/// Lines of the members that yield, in tension and in compression. @param indent of each line
std::string yielding_text(const NamedMode& mode, int indent);

/// A curve as a table, one row per breakpoint. @param variable heading of the first column
/// @param load that is carried at no factor beyond the end of the curve: "some admissible load"
/// @param scale of the variable to the places of the curve
std::string curve_text(const problems::LimitProblem& problem, const limit::LoadCurve& curve,
                       std::string_view variable, std::string_view load, double scale = 1);

/// Adds the pieces of a curve as `key`, and its end, if it has one, as `key`_end. @param scale as
/// above
void add_curve(nlohmann::ordered_json& result, const std::string& key,
               const problems::LimitProblem& problem, const limit::LoadCurve& curve,
               double scale = 1);

}  // namespace kusabi::run
