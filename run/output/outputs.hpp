// The files that one call writes, looked at together before the work begins: two of them in one
// place, or one in the place of what is read, would lose what a night has computed.
#pragma once

#include <string>
#include <vector>

namespace kusabi::run {

/// A file of the call and the option that names it.
struct NamedFile {
  std::string option;  ///< "--output"; for messages
  std::string name;    ///< empty: the option was not given
};

/// Refuses, in one line, outputs of which two are the same file or one is the file that is read,
/// and outputs that cannot be written. The same are names of one place, links followed, and two
/// names of one file (hard links), and one pipe or device; of /dev/null there is enough for all.
///
/// A checkpoint is checked by its own rules (run/session/restart.hpp); name it in `others`.
/// @param input the file that is read
/// @param outputs what will be opened as OutputFile; the files of a certificate that is written in
///        parts are PLACE and those that begin with PLACE.part.
/// @param others files that are written, too, but not tried here
/// @throws WrongInput
void check_outputs(const std::string& input, const std::vector<NamedFile>& outputs,
                   const std::vector<NamedFile>& others = {});

}  // namespace kusabi::run
