// Places of outputs are checked before the search, so that an invalid name is reported at once.
// OutputFile is a file, and OutputFolder one of many, that is written beside its destination and
// renamed, so that readers never see a partial one. The file beside is PLACE.HOST.PROCESS.tmp, locked
// while its process lives; one that a killed process has left is removed by the next process with
// the same destination.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

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

/// A folder of output files, created before the search, so that an invalid name is reported at once.
/// Each file in it appears complete or not at all.
class OutputFolder {
 public:
  /// Creates the folder unless it exists; its parent must exist. An empty name: no folder.
  /// @param option option that names the folder, for messages
  /// @param input the problem file, which must not be a file of the folder
  /// @throws WrongInput if it exists and is not a folder, or cannot be created
  OutputFolder(std::string option, const std::string& name, std::string input);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();  ///< removes a folder created here that is empty

  [[nodiscard]] bool wanted() const { return !place_.empty(); }

  /// Writes one file. @pre wanted() @throws WrongInput, std::runtime_error if it cannot be written
  void write(const std::string& file, const std::function<void(std::ostream&)>& write_to);

  /// Path of the last file written, relative to the folder as it was given; the folder if it has
  /// files that others wrote; empty if it has none.
  [[nodiscard]] std::string last() const;

 private:
  std::string option_;
  std::string input_;
  std::filesystem::path place_;
  std::filesystem::path last_;
  bool made_ = false;
};

/// A file of the call and its option.
struct NamedFile {
  std::string option;  ///< "--output"; for messages
  std::string name;    ///< empty: the option was not given
};

/// Throws if two outputs are the same file, if one is the input, or if one cannot be written. Names
/// of one destination (links are followed), names of one file (hard links), and names of one pipe
/// or device are the same; /dev/null may be used several times. State files are checked in
/// run/session/kept_state.hpp and named in `others`.
/// @param input the input file
/// @param outputs files to be opened as OutputFile; a certificate written in parts uses PLACE and
///        all names that begin with PLACE.part.
/// @param others further files that are written but not opened here
/// @throws WrongInput
void check_outputs(const std::string& input, const std::vector<NamedFile>& outputs,
                   const std::vector<NamedFile>& others = {});

/// @param read files that the input file names @throws WrongInput if an output is one of them
void check_read_files(const std::vector<std::string>& read, const std::vector<NamedFile>& outputs);

/// Runs all `steps` in order, even after an error, and then rethrows the first error; messages of
/// further errors go to standard error.
/// @throws the first error
void do_all(const std::vector<std::function<void()>>& steps);

}  // namespace kusabi::run
