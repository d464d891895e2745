// Parts that a large and a small picture of an answer have in common: names, numbers, reactions.
#pragma once

#include <string>
#include <string_view>

#include "pictures/html/markup.hpp"
#include "run/report/answers.hpp"
#include "run/report/gallery.hpp"

namespace kusabi::run {

/// "Pattern 12" for "patterns".
std::string title_of(const AnswerList& list, const Answer& answer);

/// Opens an element with data attributes for the script that sorts and filters.
/// @param rank place in the order, from 0
void open_answer(pictures::Markup& page, std::string_view tag, std::string_view kind,
                 const Answer& answer, std::size_t rank);

/// Meaning of a number of an answer.
std::string meaning(const AnswerList& list, std::string_view key);

/// A number of an answer with its standing.
void add_number(pictures::Markup& page, const AnswerNumber& number);

/// The friction coefficient that its reactions need.
void add_needed(pictures::Markup& page, const Answer& answer);

/// A list of terms: candidates, numbers, friction.
void add_terms(pictures::Markup& page, const AnswerList& list, const Answer& answer);

/// The table of reactions, folded. @throws WrongInput
void add_reactions(pictures::Markup& page, const ResultReader& reader, const AnswerList& list,
                   const Answer& answer);

}  // namespace kusabi::run
