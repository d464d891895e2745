// The verdict beneath a table: headline, reservations, warnings of the input.
#pragma once

#include <string>

#include "run/output/page.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

/// Lines that end a table; empty without a question and without warnings.
std::string conclusion_text(const Verdict& verdict, const Page& page);

}  // namespace kusabi::run
