// A search as a person sees it: with the limits of the call, stopped by signals, and its progress
// shown on rank 0.
#pragma once

#include <optional>
#include <utility>

#include "engine/search.hpp"
#include "run/progress_line.hpp"
#include "run/session.hpp"
#include "run/signals.hpp"

namespace kusabi::run {

/// engine::search on all ranks. @param options is completed by the limits, the signals and, unless
/// `quiet`, the progress line; objectives are shown times `shown_factor`, -1 where a maximum is
/// searched for as a minimum
template <class Tree>
engine::Outcome<Tree> shown_search(Session& session, Tree& tree, engine::Options options,
                                   const engine::Limits& limits, bool quiet,
                                   double shown_factor = 1) {
  options.limits = limits;
  options.interrupt = asked_by_signal;
  std::optional<ProgressLine> progress;
  if (session.speaks() && !quiet) {
    progress.emplace(options.goal, shown_factor);
    options.progress = [&](const auto& state) { progress->show(state); };
  }
  heed_signals();
  return engine::search(tree, session.transport(), options);
}

}  // namespace kusabi::run
