// Length of tests: a few seeds, kills and rounds at each change; with the CMake option
// KUSABI_THOROUGH, which .ci/nightly sets, as many as it takes to find rare errors.
#pragma once

namespace kusabi::test {

#ifdef KUSABI_THOROUGH
inline constexpr bool thorough = true;
#else
inline constexpr bool thorough = false;
#endif

}  // namespace kusabi::test
