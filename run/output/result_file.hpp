// The JSON result file.
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "run/output/json_writer.hpp"
#include "run/output/output_file.hpp"

namespace kusabi::run {

class ResultFile {
 public:
  /// @param name as for OutputFile; empty: nothing will be written
  /// @throws WrongInput if it cannot be written
  ResultFile(const std::string& name, const std::string& input);

  [[nodiscard]] bool wanted() const { return file_.wanted(); }

  /// Writes `result` and puts the file into its place.
  /// @throws std::runtime_error if the disk is full, or the like.
  void write(const nlohmann::ordered_json& result);

  /// The same for a result that is too long to be held: `write` is given the writer of the file.
  void write(const std::function<void(JsonWriter&)>& write);

 private:
  OutputFile file_;
};

}  // namespace kusabi::run
