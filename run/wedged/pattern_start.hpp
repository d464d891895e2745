// Definition of the coefficient at which a pattern becomes feasible, printed beneath tables.
#pragma once

namespace kusabi::run {

inline constexpr const char* begins_explained =
    "       (a pattern exists at a friction coefficient if some configuration loads exactly its\n"
    "        candidates in contact and separates exactly its separated ones)\n";

}  // namespace kusabi::run
