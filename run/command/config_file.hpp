// Defaults of options from a TOML file: a table for each subcommand, whose keys are its options
// without their dashes. What the call has goes before it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "run/command/command_list.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// What a run has taken from the file.
struct Defaults {
  std::string file;
  std::vector<std::pair<std::string, std::string>> taken;  ///< options and values; may be empty
};

/// Reads the file on rank 0 and takes what it has for `entry`, and the call has not, on every rank.
///
/// The file is that of --config, else of KUSABI_CONFIG (if that is empty, none), else
/// kusabi/config.toml in XDG_CONFIG_HOME or ~/.config, which need not be there. An option that
/// needs another one which neither the call nor the file has is left out.
/// @throws WrongInput, support::InputError on every rank alike, with file, line and key
Defaults take_defaults(Session& session, const CommandList& list, CommandList::Entry& entry);

}  // namespace kusabi::run
