// The structure in a result file, so that whoever draws an answer needs no problem file.
#pragma once

#include <nlohmann/json.hpp>

#include "problems/structure/structure.hpp"

namespace kusabi::run {

/// Names and positions of the nodes, members, elements, supports, candidates and loads
/// (docs/result-files.md). Nodes are told by their numbers, from 0; what there is nothing of is
/// left out.
nlohmann::ordered_json structure_json(const problems::Structure& structure);

}  // namespace kusabi::run
