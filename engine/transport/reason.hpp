// Message of an error that ends a run.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::engine {

/// @param what of the exception; that of std::bad_alloc, alone or as the cause at a node, becomes a
///        sentence
inline std::string reason_of(std::string_view what) {
  constexpr std::string_view no_memory = "std::bad_alloc";
  if (!what.ends_with(no_memory)) return std::string(what);
  what.remove_suffix(no_memory.size());
  return std::string(what) +
         "out of memory; expected more memory, a smaller problem, or a limit of the search";
}

}  // namespace kusabi::engine
