// The JSON result file: written beside its place and renamed, so that a reader never sees half of
// one, and opened before the work begins, so that a wrong name costs a second and not a night.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace kusabi::run {

class ResultFile {
 public:
  /// Opens a file beside `name`, or `name` itself if it is a device or a pipe. A link is followed.
  /// An empty name: nothing will be written.
  /// @param input the problem file, which must not be the same
  /// @throws WrongInput if it cannot be written
  ResultFile(const std::string& name, const std::string& input);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();  ///< leaves nothing behind unless the result is in its place

  /// Writes `result` and puts the file into its place.
  /// @throws std::runtime_error if the disk is full, or the like.
  void write(const nlohmann::ordered_json& result);

 private:
  std::filesystem::path place_;
  std::filesystem::path beside_;  // empty: the place is written to directly
  std::ofstream file_;
};

}  // namespace kusabi::run
