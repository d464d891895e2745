// `kusabi limit FILE`: the load factor at which a truss collapses (limit paper (5)), and with
// `--alpha` the least one that an uncertain dead load can bring about ((13)).
#pragma once

#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/limit/model/limit_question.hpp"
#include "problems/limit/half_widths.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct LimitOptions {
  std::string file;
  std::string load_case;   ///< the one that is asked for; empty: all
  std::string curve_load;  ///< the file of a load of one's own
  problems::AskedHalfWidths asked;
  limit::LimitQuestion question;  ///< its alpha follows from `asked` and the file
  engine::Limits limits;          ///< where the search of a tree stops early
  CheckpointChoice checkpoint;
};

std::unique_ptr<Subcommand> limit_subcommand();

}  // namespace kusabi::run
