// Load cases of a problem file, and the governing one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::run {

/// A load case and its results; a file without cases has one without a name.
struct LimitCase {
  std::string name;
  problems::CheckedStructure truss;
  problems::LimitProblem problem;
  limit::LimitFindings found{};
};

/// The case with the least known load factor, worst or nominal, with struts at their residual
/// strength: before all others one whose load is carried at no factor, then one of which a loss
/// leaves none, then those of which this is so at residual strength; the first of equal ones.
/// Tables, sentences and files name this one. @pre there is one
const LimitCase& governing(std::span<const LimitCase> cases);

/// True if all cases are answered.
bool all_whole(std::span<const LimitCase> cases);

/// Addition to the title of a table of factors of a truss with struts.
inline constexpr const char* upper_values = ", all struts at their strength: upper values";

/// True if the case is a combination of actions with ranges of factors: with all in the middle, the
/// nominal load has no meaning of its own.
bool has_ranges(const problems::Structure& truss);

/// True if the load factors of the answer are those carried under every admissible load: a worst
/// case was requested, and some case has one, or no nominal load is carried at no factor.
bool of_all_loads(std::span<const LimitCase> cases, const limit::LimitParameters& parameters);

/// True if some members are struts: their results at residual strength are lower values.
bool with_struts(std::span<const LimitCase> cases);

/// True if each case has proved theorems, as a certificate requires: with the loss of members, those
/// on the requested losses; without, those on load factors.
bool have_theorems(std::span<const LimitCase> cases, bool of_losses);

/// The proved theorems of all cases, for one certificate; on losses at residual strength if each
/// case has one. @pre have_theorems()
std::vector<verify::TrussTheorem> all_theorems(std::span<const LimitCase> cases, bool of_losses);

/// Load factors carried in all cases. @param all_loads under every admissible load; otherwise under
/// the nominal ones
limit::GuaranteedInterval interval_of_all(std::span<const LimitCase> cases, bool all_loads);

/// The loads of a statement on all cases: " under all admissible loads". @param alpha of the search
std::string loads_text(std::span<const LimitCase> cases, std::optional<double> alpha);

/// A load that is carried at no factor: "some admissible dead load", "some combination of actions".
/// @param uncertain some admissible load; otherwise the dead load
const char* load_without_factor(const problems::Structure& truss, bool uncertain);

/// "some admissible dead load is carried at no load factor of either sign, proved".
/// @param uncertain as above
std::string at_none_text(const problems::Structure& truss, bool uncertain,
                         support::Standing standing);

/// The same on a case without a loss; nothing: it is not known that a load has no factor.
std::optional<std::string> at_none_text(const problems::Structure& truss,
                                        const limit::LimitAnswer& answer);

/// One row per case, and the governing case.
std::string cases_text(std::span<const LimitCase> cases, const limit::LimitParameters& parameters);

/// The key `cases` of a result.
nlohmann::ordered_json cases_json(std::span<const LimitCase> cases);

}  // namespace kusabi::run
