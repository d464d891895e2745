// The structure in a result file, so that whoever draws an answer needs no problem file.
#pragma once

#include <cstddef>
#include <vector>

#include <nlohmann/json.hpp>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Names and positions of the nodes, members, elements, supports, candidates and loads
/// (docs/result-files.md). Nodes are told by their numbers, from 0; what there is nothing of is
/// left out.
nlohmann::ordered_json structure_json(const problems::Structure& structure);

/// The elements as they are listed there, shape by shape: of each its place in the structure.
std::vector<std::size_t> listed_elements(const problems::Structure& structure);

}  // namespace kusabi::run
