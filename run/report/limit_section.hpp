// Limit loads on a page: interval, collapse modes, utilisation of members.
#pragma once

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {

/// @throws WrongInput
void add_limit(pictures::Markup& page, const ResultReader& reader, const ResultScenes& scenes);

}  // namespace kusabi::run
