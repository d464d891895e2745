// Answer: a pattern or ray of a result file, for the list of a page.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/results/result_reader.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {

/// A number of an answer.
struct AnswerNumber {
  std::string key;          ///< of the result file
  const ResultJson* value;  ///< null: unknown
  std::string text{};       ///< as it is shown; empty: rounded as its key says
  std::string standing{};   ///< empty: not in the file
};

struct Answer {
  std::size_t number;  ///< from 1 on, in the order of the file
  std::vector<std::string> contact;
  std::vector<std::string> separated;
  std::vector<std::string> inactive;
  std::string state;                       ///< in words; empty: it holds, or the file does not say
  std::vector<AnswerNumber> numbers;       ///< margin, or lower and upper bound
  std::string load;                        ///< of a state under load: "at factor 1.4"
  std::optional<double> order;             ///< margin or upper bound, for sorting
  std::optional<double> needed;            ///< friction coefficient that its reactions need
  std::string needed_text;                 ///< the same, rounded up
  std::vector<std::string> slips;          ///< candidates that slip at this coefficient
  const ResultJson* reaction = nullptr;    ///< one row per candidate; null: not in the file
  const pictures::Scene* scene = nullptr;  ///< null: none
};

/// Empty if the file is not of patterns, rays or critical. Answers point into the reader.
/// @throws WrongInput
std::vector<Answer> answers(const ResultReader& reader);

/// Indices of the answers, the leading one first: largest margin, or least friction coefficient.
/// Those without are last.
std::vector<std::size_t> by_rank(const ResultReader& reader, const std::vector<Answer>& answers);

/// Gives the answers their scenes. @param scenes of these answers; they must outlive them
void attach(const ResultScenes& scenes, std::vector<Answer>& answers);

}  // namespace kusabi::run
