// Answers of a page: pictures with numbers, to be filtered and sorted.
#pragma once

#include <vector>

#include "pictures/html/markup.hpp"
#include "run/report/answers.hpp"

namespace kusabi::run {

/// Maximum number of pictures, and maximum size of all of them in bytes, so that a phone can open
/// the page.
inline constexpr std::size_t most_pictures = 300;
inline constexpr std::size_t most_picture_bytes = 24'000'000;

/// A list of answers with pictures, and a table of the others.
/// @param things plural noun for answers: "patterns"
void add_gallery(pictures::Markup& page, const ResultReader& reader, const std::string& things,
                 const std::vector<Answer>& answers);

}  // namespace kusabi::run
