// Test program for the agreement of ranks on the problem. With the argument `different` the last
// rank has another fingerprint, and all ranks must end with the line that rank 0 prints.
#include <cstdio>
#include <cstring>
#include <exception>

#include "engine/collectives.hpp"
#include "run/session/session.hpp"

int main(int argc, char** argv) {
  kusabi::run::Session session(argc, argv);
  const bool different = argc > 1 && std::strcmp(argv[1], "different") == 0;
  const bool last = session.transport().rank() == session.ranks() - 1;
  try {
    kusabi::engine::require_equal_on_all_ranks(session.transport(),
                                               different && last ? 0xBAD : 0x900D);
  } catch (const kusabi::engine::RankMismatch& error) {
    if (session.is_first()) std::printf("%s\n", error.what());
    return 0;
  }
  if (session.is_first()) std::printf("all ranks agree\n");
  return 0;
}
