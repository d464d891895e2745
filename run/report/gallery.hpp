// The answers of a page: pictures with their numbers, to be filtered and sorted.
#pragma once

#include <vector>

#include "pictures/html/markup.hpp"
#include "run/report/answers.hpp"

namespace kusabi::run {

/// The first have a picture, as many as that and as long as these come to no more than so many
/// bytes: a page has to open on a phone.
inline constexpr std::size_t most_pictures = 300;
inline constexpr std::size_t most_picture_bytes = 24'000'000;

/// A list of those with a picture, and a table of the others.
/// @param things what they are, in the plural: "patterns"
void add_gallery(pictures::Markup& page, const ResultReader& reader, const std::string& things,
                 const std::vector<Answer>& answers);

}  // namespace kusabi::run
