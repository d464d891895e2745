// OutputSet: the output files and folders of a call, by option, on rank 0.
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "run/command/option_table.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/output_file.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Name of standard output in a call.
inline constexpr const char* standard_output = "-";

class OutputSet {
 public:
  /// @pre the table outlives this object
  explicit OutputSet(const OptionTable& table) : table_(table) {}

  /// Checks the names of all files of the call together and opens the outputs, on rank 0.
  /// @param input the first input file @throws WrongInput on every rank
  void open(Session& session, const std::string& input);

  /// Checks that no output is one of these files, which the input file names.
  /// @throws WrongInput on every rank
  void keep(Session& session, const std::vector<std::string>& read) const;

  [[nodiscard]] bool wants(const std::string& option) const;
  /// @pre wants(option)
  [[nodiscard]] std::ostream& stream(const std::string& option);
  /// @pre wants(option)
  void put_in_place(const std::string& option);

  /// Writes a file, if requested. @param write may be empty if `stream` has received everything
  Step file(const std::string& option, std::function<void(std::ostream&)> write);
  /// Fills a folder, if requested.
  Step folder(const std::string& option, std::function<void(OutputFolder&)> fill);

  /// Names of the files that are in place.
  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }

 private:
  /// All outputs of the call.
  [[nodiscard]] std::vector<NamedFile> names() const;
  void check(const std::string& input) const;

  const OptionTable& table_;
  std::map<std::string, OutputFile> files_;
  std::map<std::string, OutputFolder> folders_;
  std::vector<std::string> written_;
};

}  // namespace kusabi::run
