// The first error is thrown after all steps.
#include "run/output/last_steps.hpp"

#include <exception>

#include "engine/transport/reason.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {

void do_all(const std::vector<std::function<void()>>& steps) {
  std::exception_ptr first;
  for (const auto& step : steps) {
    try {
      step();
    } catch (const std::exception& error) {
      if (first) {
        print_message("kusabi: {}\n", engine::reason_of(error.what()));
      } else {
        first = std::current_exception();
      }
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace kusabi::run
