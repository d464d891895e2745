// Reads the problem file, writes the exported file.
#include "run/export/exported_file.hpp"

#include <ostream>
#include <sstream>

#include "run/command/command_run.hpp"

namespace kusabi::run {

void ExportedFile::describe_input(OptionTable& table) {
  table.problem(input_.file);
}

void ExportedFile::describe_output(OptionTable& table) {
  table.output("file to write. Default: standard output");
  table.serial();
}

std::vector<Step> ExportedFile::results(CommandRun& run) {
  if (run.wants("--output")) {
    return {run.file("--output", [this](std::ostream& out) { write(out); })};
  }
  std::ostringstream text;
  write(text);
  return {CommandRun::print(text.str())};
}

}  // namespace kusabi::run
