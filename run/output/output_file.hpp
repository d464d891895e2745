// OutputFile: a file that is written beside its destination and renamed, so that readers never see
// a partial file. It is opened before the search, so that an invalid name is reported at once. The
// file beside is PLACE.HOST.PROCESS.tmp, locked while its process lives; one that a killed process
// has left is removed by the next process with the same destination.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace kusabi::run {

/// The name of standard output.
inline constexpr const char* standard_output_file = "/dev/stdout";

class OutputFile {
 public:
  /// Opens a file beside `name`, or `name` itself if it is a device or a pipe. standard_output_file
  /// is the open standard output, whatever it is; a file there is appended to. Links are followed.
  /// An empty name: no file.
  /// @param option option that names the file, for messages
  /// @param input the problem file, which must be another file
  /// @throws WrongInput if the file cannot be written
  OutputFile(const std::string& option, const std::string& name, const std::string& input);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  ///< removes the temporary file unless the file is complete

  [[nodiscard]] bool wanted() const { return !place_.empty(); }

  /// Stream to write to. @pre wanted()
  [[nodiscard]] std::ostream& stream();

  /// Closes the file, syncs it to disk and renames it to its destination.
  /// @pre wanted()
  /// @throws std::runtime_error on any error, such as a full disk
  void put_in_place();

 private:
  [[nodiscard]] bool is_standard_output() const { return place_ == standard_output_file; }
  std::string open_beside();  // @return an error message; empty: none

  std::filesystem::path place_;
  std::filesystem::path beside_;  // empty: the destination is written to directly
  int lock_ = -1;                 // descriptor of the temporary file
  std::ofstream file_;
};

}  // namespace kusabi::run
