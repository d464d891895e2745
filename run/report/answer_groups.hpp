// Groups of answers whose contact sets differ in few candidates, each around its leading one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "run/report/answers.hpp"

namespace kusabi::run {

struct AnswerGroup {
  std::vector<std::size_t> members;  ///< indices of answers, the leading one first
  std::vector<std::string> always;   ///< candidates in contact in all members
  std::vector<std::string> varying;  ///< candidates in contact in some members
};

struct AnswerGroups {
  std::vector<AnswerGroup> groups;  ///< by their leading members
  std::size_t apart = 0;            ///< largest number of candidates in which a member differs
};

/// Groups around the leading answers, as `kusabi patterns` prints them: the first takes the answers
/// that differ from it in at most K candidates, then the first of the rest, and so on, with the
/// least K = 2, 4, 8, ... at which `maximum` groups suffice.
/// @param order of the answers, the leading one first
AnswerGroups answer_groups(const std::vector<Answer>& answers,
                           const std::vector<std::size_t>& order, std::size_t maximum);

}  // namespace kusabi::run
