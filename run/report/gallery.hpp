// Answers of a page: the leading one large, the others in groups, with pictures and numbers, to be
// filtered and sorted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/html/markup.hpp"
#include "run/output/short_names.hpp"
#include "run/report/answer_groups.hpp"
#include "run/report/answers.hpp"

namespace kusabi::run {

/// Maximum number of pictures, and maximum size of all of them in bytes, so that a phone can open
/// the page.
inline constexpr std::size_t max_pictures = 60;
inline constexpr std::size_t max_picture_bytes = 12'000'000;

/// Maximum number of groups, and of the answers that are printed with a picture, and as rows.
inline constexpr std::size_t max_groups = 12;
inline constexpr std::size_t max_printed = 10;
inline constexpr std::size_t max_printed_rows = 100;

/// The answers of a page, in their order and in groups.
struct AnswerList {
  std::string things;     ///< plural noun: "patterns"
  std::string ranked_by;  ///< "largest margin"; empty: in the order of the file
  std::vector<Answer> answers;
  std::vector<std::size_t> order;  ///< the leading one first
  AnswerGroups groups;
  ShortNames names;
};

/// @throws WrongInput
AnswerList answer_list(const ResultReader& reader);

/// Indices of the answers that have pictures: the first of each group, then by rank; ascending.
std::vector<std::size_t> pictured(const AnswerList& list);

/// The leading answer: a large picture, which turns if it is in space, with numbers and reactions.
void add_leading(pictures::Markup& page, const ResultReader& reader, const AnswerList& list);

/// Groups of answers with pictures, and a table of the others. @pre more than one answer
void add_gallery(pictures::Markup& page, const ResultReader& reader, const AnswerList& list);

}  // namespace kusabi::run
