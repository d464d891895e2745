// Text of a verdict beneath a table: headline, reservations, warnings about the input.
#pragma once

#include <string>

#include "answer/verdict.hpp"
#include "run/output/terminal_page.hpp"

namespace kusabi::run {

/// Last lines of a table; empty if there is neither an answer nor a warning.
std::string conclusion_text(const answer::Verdict& verdict, const Page& page);

}  // namespace kusabi::run
