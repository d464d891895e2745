// Two formats, distinguished by the first character: no TOML file begins with a brace.
#include "run/limit/curve_load.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "problems/files/sections/node_forces.hpp"
#include "support/input_error.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;
using support::InputError;

Eigen::MatrixXd of_result(const std::string& text, const std::string& file,
                          const LimitProblem& problem) {
  const auto& names = problem.node_names;
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(problem.dimension, static_cast<Eigen::Index>(names.size()));
  try {
    const auto json = nlohmann::json::parse(text);
    for (const auto& entry : json.at("result").at("critical_part")) {
      const auto name = entry.at("node").get<std::string>();
      const auto force = entry.at("force").get<std::vector<double>>();
      const auto node = std::ranges::find(names, name);
      if (node == names.end() || std::ssize(force) != problem.dimension) {
        throw InputError(file, {},
                         fmt::format("the critical part of the load at {} belongs to another "
                                     "problem; expected a result with the same nodes",
                                     support::in_quotes(name)));
      }
      forces.col(node - names.begin()) =
          Eigen::Map<const Eigen::VectorXd>(force.data(), problem.dimension);
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(file, {},
                     "is not a result file with a critical_part; expected a result of kusabi limit "
                     "--alpha, or a TOML file with [[loads]]");
  }
  return forces;
}

}  // namespace

Eigen::VectorXd curve_load(const std::string& text, const std::string& file,
                           const problems::Structure& truss, const LimitProblem& problem) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool is_result = first != std::string::npos && text[first] == '{';
  const Eigen::MatrixXd forces =
      is_result ? of_result(text, file, problem) : problems::read_node_forces(text, file, truss);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(problem.free_count());
  for (int node = 0; node < static_cast<int>(problem.node_names.size()); ++node) {
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const int degree = problem.degrees.number(axis, node);
      if (degree >= 0) load(degree) = forces(axis, node);
    }
  }
  if (load.isZero(0.0)) {
    throw InputError(file, {},
                     "the load is zero at all free displacements; expected a force at a free node "
                     "along a free axis");
  }
  return load;
}

}  // namespace kusabi::run
