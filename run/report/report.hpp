// `kusabi report RESULT`: a result file as a self-contained HTML page.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> report_subcommand();

}  // namespace kusabi::run
