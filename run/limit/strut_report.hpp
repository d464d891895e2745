// Struts of a truss: the load factor at their strength and at their residual strength after
// buckling, and the struts at their strength.
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "run/limit/limit_cases.hpp"
#include "run/limit/limit_report.hpp"

namespace kusabi::run {

/// Lines of the table. @pre report.residual
std::string strut_text(const LimitReport& report);

/// The key `struts` of a result. @pre report.residual
nlohmann::ordered_json strut_json(const LimitReport& report);

/// "With all struts at their residual strength no load factor is carried.", if that is so in some
/// case; empty otherwise, and if some case is carried at no factor at full strength either.
std::string strut_sentence(std::span<const LimitCase> cases);

}  // namespace kusabi::run
