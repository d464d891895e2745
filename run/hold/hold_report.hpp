// Results of `kusabi hold`: the table and the JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/wedged/hold/load_program.hpp"
#include "run/hold/hold.hpp"

namespace kusabi::run {

/// Names of the candidates in contact, for tables.
std::string contact_of(const wedged::LoadedProblem& loaded, std::uint32_t block,
                       const std::optional<wedged::LoadedPattern>& pattern);
/// The same of a pattern of the whole problem.
std::string contact_of(const wedged::LoadedProblem& loaded, const wedged::LoadedPattern& pattern);
/// Names of the candidates in contact and of those separated. @param pattern of the whole problem
nlohmann::ordered_json pattern_names(const wedged::LoadedProblem& loaded,
                                     const wedged::LoadedPattern& pattern);

/// Bracket or intervals, and the costs of the searches.
std::string hold_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                       const HoldFindings& findings);

/// The member `result` of a result file.
nlohmann::ordered_json hold_json(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                                 const HoldFindings& findings);

/// The costs of the searches: its member `statistics`.
nlohmann::ordered_json costs_json(const HoldFindings& findings);

}  // namespace kusabi::run
