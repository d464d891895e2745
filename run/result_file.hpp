// The JSON result file: written beside its place and renamed, so that a reader never sees half of
// one, and opened before the work begins, so that a wrong name costs a second and not a night.
#pragma once

#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace kusabi::run {

class ResultFile {
 public:
  /// Opens `name`.tmp. An empty name: nothing will be written.
  /// @throws WrongInput if it cannot be written.
  explicit ResultFile(const std::string& name);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();  ///< leaves nothing behind if nothing was written

  /// Writes `result` and puts the file into its place.
  /// @throws std::runtime_error if the disk is full, or the like.
  void write(const nlohmann::ordered_json& result);

 private:
  std::string name_;
  std::string beside_;
  std::ofstream file_;
};

}  // namespace kusabi::run
