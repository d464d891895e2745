// A file that the command writes: beside its place and renamed, so that a reader never sees half of
// one, and opened before the work begins, so that a wrong name costs a second and not a night.
//
// The file beside is named PLACE.HOST.PROCESS.tmp and locked while its process lives. One that was
// left by a process that was killed is removed by the next that writes to the same place; nothing
// ever stands in the way.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace kusabi::run {

/// The name of standard output.
inline constexpr const char* standard_output_file = "/dev/stdout";

class OutputFile {
 public:
  /// Opens a file beside `name`, or `name` itself if it is a device or a pipe;
  /// standard_output_file is what is open already, wherever that leads: a file there keeps what it
  /// has. A link is followed.
  /// An empty name: nothing will be written.
  /// @param option the option of the command that names it, for messages
  /// @param input the problem file, which must not be the same
  /// @throws WrongInput if it cannot be written
  OutputFile(const std::string& option, const std::string& name, const std::string& input);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();  ///< leaves nothing behind unless the file is in its place

  [[nodiscard]] bool wanted() const { return !place_.empty(); }

  /// Where to write to. @pre wanted()
  [[nodiscard]] std::ostream& stream();

  /// Closes the file, syncs it to the disk and puts it into its place.
  /// @pre wanted()
  /// @throws std::runtime_error if the disk is full, or the like.
  void put_in_place();

 private:
  [[nodiscard]] bool is_standard_output() const { return place_ == standard_output_file; }
  std::string open_beside();  // @return what is wrong, or nothing

  std::filesystem::path place_;
  std::filesystem::path beside_;  // empty: the place is written to directly
  int lock_ = -1;                 // a descriptor of the file beside
  std::ofstream file_;
};

}  // namespace kusabi::run
