// JSON of whoever wrote it, made a tree in time that grows as the text does.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace kusabi::run {

using ResultJson = nlohmann::ordered_json;

/// Result files go eight deep; whoever walks through a tree goes down as far as it does.
inline constexpr int deepest_result = 32;

struct ParsedResult {
  ResultJson json;  ///< discarded if the text is no JSON, or is too deep
  bool too_deep = false;
};

/// Of a key that comes again in one object the first counts: to look for it among all others would
/// take a minute where all nodes of a body are listed.
ParsedResult parse_result(const std::string& text);

}  // namespace kusabi::run
