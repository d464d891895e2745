// Parts of a page that all results have: numbers, names and tables of what is told by a key.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Digits that are shown: of a number among many, and of one that is an answer.
inline constexpr int few_digits = 6;
inline constexpr int many_digits = 10;

/// A data element that shows so many digits and has the number of the file as its value; "–" if
/// null.
void add_number(pictures::Markup& page, const ResultJson* value, int digits = few_digits);

/// The same of a count, which may be decimal digits.
void add_count(pictures::Markup& page, const ResultJson* value);

/// Names as text; "–" if there are none.
std::string joined(const std::vector<std::string>& names);

/// Opens a table in a box that scrolls where it is too wide for the screen, also by the arrow keys;
/// both are to be closed.
void open_table(pictures::Markup& page, std::string_view caption);

/// The same with a row of titles; its rows come next.
void begin_table(pictures::Markup& page, std::string_view caption,
                 const std::vector<std::string>& columns);
void end_table(pictures::Markup& page);

/// A table of the keys and values of an object; what is an object within is told as "key, key".
/// Lists of more than that a person reads are counted.
void add_facts(pictures::Markup& page, std::string_view caption, const ResultJson& object);

/// Name, file, sizes, units, fingerprint. @throws WrongInput
void add_problem(pictures::Markup& page, const ResultReader& reader);

/// How it was called, the search tree, all fingerprints. @throws WrongInput
void add_origin(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
