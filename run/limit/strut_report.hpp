// Struts of a truss: the load factor at their strength and at their residual strength after
// buckling, and the struts at their strength.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/limit_loads.hpp"
#include "run/limit/limit_report.hpp"

namespace kusabi::run {

/// Lines of the table. @pre report.residual
std::string strut_text(const LimitReport& report);

/// The key `struts` of a result. @pre report.residual
nlohmann::ordered_json strut_json(const LimitReport& report);

/// "With all struts at their residual strength it is at least 0.5." @pre found.residual
std::string strut_sentence(const limit::LimitFindings& found);

}  // namespace kusabi::run
