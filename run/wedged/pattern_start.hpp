// Definition of the coefficient at which a pattern becomes feasible, printed beneath tables.
#pragma once

namespace kusabi::run {

inline constexpr const char* begins_explained =
    "       (a pattern begins at the least coefficient at which some configuration loads exactly "
    "its "
    "candidates in contact and opens exactly those separated)\n";

}  // namespace kusabi::run
