// Output files of a call, checked together before the search: two outputs with the same
// destination, or one that would overwrite the input, are errors.
#pragma once

#include <string>
#include <vector>

namespace kusabi::run {

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

}  // namespace kusabi::run
