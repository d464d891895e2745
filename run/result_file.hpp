// The JSON result file.
#pragma once

#include <functional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "run/output_file.hpp"

namespace kusabi::run {

/// A list that is too long to be held: `result` has `mark` in its place, and `next` yields one
/// element after another until it returns false.
struct LongList {
  std::string mark;
  std::function<bool(nlohmann::ordered_json& element)> next;
};

class ResultFile {
 public:
  /// @param name as for OutputFile; empty: nothing will be written
  /// @throws WrongInput if it cannot be written
  ResultFile(const std::string& name, const std::string& input);

  /// Writes `result` and puts the file into its place.
  /// @throws std::runtime_error if the disk is full, or the like.
  void write(const nlohmann::ordered_json& result);

  /// The same for a result with `lists`, in the order in which they stand in it. `result` is called
  /// anew after each, so that what follows a list may hang on it.
  void write(const std::function<nlohmann::ordered_json()>& result,
             std::span<const LongList> lists);

 private:
  OutputFile file_;
};

}  // namespace kusabi::run
