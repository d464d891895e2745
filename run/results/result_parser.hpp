// JSON text to tree in linear time, safe for files of unknown origin.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace kusabi::run {

using ResultJson = nlohmann::ordered_json;

/// Maximum depth; result files need eight. Recursive readers of the tree go as deep.
inline constexpr int deepest_result = 32;

struct ParsedResult {
  ResultJson json;  ///< discarded if the text is no JSON or too deep
  bool too_deep = false;
};

/// One object, or lines of --format jsonl as the object that has their list. The first of equal
/// keys counts: a search for each key would take a minute for the nodes of a large body.
ParsedResult parse_result(const std::string& text);

}  // namespace kusabi::run
