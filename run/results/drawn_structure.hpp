// Structure of a result file, prepared for pictures: the common part of all answers.
#pragma once

#include <map>
#include <string>

#include "pictures/svg/scene.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

struct DrawnStructure {
  pictures::Scene scene;             ///< undeformed, candidates without a state
  std::map<std::string, int> nodes;  ///< indices by name
  std::map<std::string, std::size_t> candidates;
  std::vector<Eigen::Matrix3d> frames;  ///< of the candidates: columns n, t1, t2
};

/// @throws WrongInput
DrawnStructure drawn_structure(const ResultReader& reader);

}  // namespace kusabi::run
