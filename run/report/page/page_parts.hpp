// Parts of all pages: head, lists of sentences, figures.
#pragma once

#include <string>
#include <vector>

#include "pictures/html/markup.hpp"

namespace kusabi::run {

/// Opens html and body, with a head in between.
void begin_page(pictures::Markup& page, const std::string& title);

/// A list, unless it is empty.
void add_list(pictures::Markup& page, const char* id, const std::vector<std::string>& sentences);

/// Opens a figure. @param turning data of turning_view.hpp; empty: it does not turn
void open_figure(pictures::Markup& page, const std::string& turning);

}  // namespace kusabi::run
