// First sentence of a page: the leading answer, the friction that it needs, and what slips first.
#pragma once

#include <string>
#include <vector>

#include "answer/verdict.hpp"
#include "run/report/answers.hpp"
#include "run/report/short_names.hpp"

namespace kusabi::run {

/// Empty if there is nothing to say beyond the verdict: no answer is known.
/// @param verdict of the file  @param leading the first by rank; null: none
/// @throws WrongInput
std::string first_sentence(const ResultReader& reader, const answer::Verdict& verdict,
                           const Answer* leading, const ShortNames& names);

}  // namespace kusabi::run
