// Short texts for sets of candidates: "all 16", "all but a b", or their names with ranges.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace kusabi::run {

class ShortNames {
 public:
  /// @param candidates names of all
  explicit ShortNames(const std::vector<std::string>& candidates);

  /// "all 16", "all but a…c", or "a…c d". Names are in natural order: a2 before a10. Of pairs of
  /// bodies, "a|b", only the node a is named unless it is in several pairs.
  [[nodiscard]] std::string of(const std::vector<std::string>& names) const;
  /// The same if it has at most so many characters; otherwise "12 of 40 candidates".
  [[nodiscard]] std::string of(const std::vector<std::string>& names, std::size_t maximum) const;

 private:
  [[nodiscard]] std::vector<std::string> in_order(const std::vector<std::string>& names,
                                                  bool others) const;

  std::vector<std::string> order_;            // short names in natural order
  std::map<std::string, std::size_t> place_;  // index in `order_`, by full name
};

}  // namespace kusabi::run
