// Defaults of options from a TOML file: one table per subcommand, with option names without dashes
// as keys. Options of the call override them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "run/command/command_list.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Defaults used by a run.
struct Defaults {
  std::string file;
  std::vector<std::pair<std::string, std::string>> taken;  ///< options and values; may be empty
};

/// Reads the file on rank 0 and sets, on every rank, the options of `entry` that the call does not
/// have. The file is that of --config, otherwise of KUSABI_CONFIG (none if that is empty),
/// otherwise kusabi/config.toml in XDG_CONFIG_HOME or ~/.config, which may be absent. An option
/// that requires another one that neither the call nor the file has is left out.
/// @throws WrongInput, support::InputError on every rank, with file, line and key
Defaults take_defaults(Session& session, const CommandList& list, CommandList::Entry& entry);

}  // namespace kusabi::run
