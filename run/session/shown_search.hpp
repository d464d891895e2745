// A search as a person sees it: with the limits of the call, stopped by signals, and its progress
// shown on rank 0.
#pragma once

#include <optional>
#include <utility>

#include "engine/search.hpp"
#include "engine/signals.hpp"
#include "run/session/progress_line.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// engine::search on all ranks. @param options is completed by the limits, the signals (unless it
/// has an `interrupt`) and, unless `quiet`, the progress line
/// @param shown how the progress line shows objectives
template <class Tree>
engine::Outcome<Tree> shown_search(Session& session, Tree& tree, engine::Options options,
                                   const engine::Limits& limits, bool quiet,
                                   const ShownObjective& shown = {}) {
  options.limits = limits;
  if (!options.interrupt) options.interrupt = engine::asked_by_signal;
  std::optional<ProgressLine> progress;
  if (session.speaks() && !quiet) {
    progress.emplace(options.goal, shown);
    options.progress = [&](const auto& state) { progress->show(state); };
  }
  engine::heed_signals();
  return engine::search(tree, session.transport(), options);
}

}  // namespace kusabi::run
