// The patterns or rays of a result file, as a page lists them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/results/result_reader.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {

struct Answer {
  std::size_t number;  ///< from 1 on, in the order of the file
  std::vector<std::string> contact;
  std::vector<std::string> separated;
  std::vector<std::string> at_rest;
  std::string state;  ///< empty: the file tells none
  /// What is told of it, by its name: margin, or the ends of a bracket. Null: not known.
  std::vector<std::pair<std::string, const ResultJson*>> numbers;
  std::optional<double> order;             ///< margin or upper end, to sort by
  const ResultJson* reaction = nullptr;    ///< a row a candidate; null: none is told
  const pictures::Scene* scene = nullptr;  ///< null: there is none
};

/// Empty if the file is not of patterns, rays or critical. They point into the reader and the
/// scenes. @throws WrongInput
std::vector<Answer> answers(const ResultReader& reader, const ResultScenes& scenes);

}  // namespace kusabi::run
