// Parts of a page common to all results: numbers, names, and tables of keys and values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Digits of a number in a table, and of an answer.
inline constexpr int few_digits = 6;
inline constexpr int many_digits = 10;
/// As many as distinguish a number from all others.
inline constexpr int all_digits = 0;

/// Direction in which a number is rounded for display.
enum class Rounding { nearest, down, up };

/// That of a number with this key of a result file: down for lower bounds, up for upper bounds.
Rounding rounding_of(std::string_view key);

/// A data element with so many digits as text and the number of the file as its value; "–" if null.
void add_number(pictures::Markup& page, const ResultJson* value, int digits = few_digits,
                Rounding rounding = Rounding::nearest);

/// The same for the bound `key`, "lower" or "upper", of a bracket, rounded outwards; "–" if it is
/// open. @param bracket null: there is none @throws WrongInput
void add_bound(pictures::Markup& page, const ResultReader& reader, const ResultJson* bracket,
               const char* key, int digits = many_digits);

/// The standing of that bound; "–" if it is open. @throws WrongInput
std::string standing_of(const ResultReader& reader, const ResultJson* bracket, const char* key);

/// The same for a count, which may be a string of decimal digits.
void add_count(pictures::Markup& page, const ResultJson* value);

/// Names as text; "–" if there are none.
std::string joined(const std::vector<std::string>& names);

/// Opens a table in a box that scrolls horizontally, also by arrow keys; the caller closes both.
void open_table(pictures::Markup& page, std::string_view caption);

/// The same with a heading row; the caller adds further rows.
void begin_table(pictures::Markup& page, std::string_view caption,
                 const std::vector<std::string>& columns);
void end_table(pictures::Markup& page);

/// A table of keys and values of an object; nested objects become rows "key, key". Only the length
/// of long lists is shown.
void add_facts(pictures::Markup& page, std::string_view caption, const ResultJson& object);

/// The same, row by row: a row without words is left out. The caller ends it by end_table.
void begin_facts(pictures::Markup& page, std::string_view caption);
void add_fact(pictures::Markup& page, std::string_view name, std::string_view words);

/// The row "NAME (proved)" of a bound of a bracket; nothing if it is open. @throws WrongInput
void add_bound_fact(pictures::Markup& page, const ResultReader& reader, std::string_view name,
                    const ResultJson& bracket, const char* key);

/// Call, search tree, fingerprints. @throws WrongInput
void add_origin(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
