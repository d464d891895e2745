// The load cases of a problem file, one after another, and which of them governs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::run {

/// A load case and what has been found of it; of a file without cases the only one, without a name.
struct LimitCase {
  std::string name;
  problems::Structure truss;
  problems::LimitProblem problem;
  limit::LimitFindings found{};
};

/// The one with the least load factor, worst or nominal, of those that are known; of equals the
/// first. @pre there is one
const LimitCase& governing(std::span<const LimitCase> cases);

/// Whether all are answered.
bool all_whole(std::span<const LimitCase> cases);

/// Whether there is a proved claim on each case, as a certificate wants it.
bool have_statements(std::span<const LimitCase> cases);

/// The proved claims on all cases, for one certificate. @pre have_statements()
std::vector<verify::LimitStatement> all_statements(std::span<const LimitCase> cases);

/// The factors that are carried in all cases, under every admissible load.
/// @pre a worst case was asked for
limit::GuaranteedInterval interval_of_all(std::span<const LimitCase> cases);

/// A row a case, and which governs.
std::string cases_text(std::span<const LimitCase> cases);

/// The key `cases` of a result.
nlohmann::ordered_json cases_json(std::span<const LimitCase> cases);

}  // namespace kusabi::run
