// Computation on each rank, and agreement that all ranks have completed it.
#include "nodes/wedged/tree/stiffness_enclosure.hpp"

#include <fmt/format.h>

#include "engine/collectives.hpp"

namespace kusabi::wedged {
namespace {

support::LongWork long_work(engine::Analysis& analysis) {
  return {
      .stop = analysis.budget().stop(), .on_share = [&analysis](const char* work, double share) {
        analysis.say_now_and_then([&] { return fmt::format("{}: {:.0f} %", work, 100 * share); });
      }};
}

}  // namespace

std::optional<StiffnessEnclosure> enclosed_within(engine::Analysis& analysis,
                                                  const problems::Structure& structure,
                                                  EncloseStiffness enclose) {
  std::optional<StiffnessEnclosure> enclosed;
  try {
    enclosed.emplace(enclose(structure, long_work(analysis)));
  } catch (const support::Stopped&) {
    enclosed.reset();
  }
  const engine::Reduction own{.ranks = 1, .found = enclosed ? 0U : 1U};
  if (engine::all_reduce(analysis.transport(), own).found != 0) enclosed.reset();
  return enclosed;
}

}  // namespace kusabi::wedged
