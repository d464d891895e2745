// Pairs of factors of two reference loads, and intervals of one: JSON and CSV.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "nodes/wedged/hold/load_program.hpp"
#include "run/hold/hold.hpp"

namespace kusabi::run {

/// The pieces of the diagram.
nlohmann::ordered_json pieces_json(const wedged::LoadedProblem& loaded,
                                   const wedged::Diagram& diagram);

/// One row per piece.
std::string diagram_table(const wedged::LoadedProblem& loaded, const wedged::Diagram& diagram);

/// One row per vertex or direction of a piece, or per interval.
void write_held_csv(std::ostream& out, const HoldOptions& options,
                    const wedged::LoadedProblem& loaded, const HoldFindings& findings);

}  // namespace kusabi::run
