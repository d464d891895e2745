// Flushing and naming.
#include "run/standard_output.hpp"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

namespace kusabi::run {

void flush_standard_output() {
  if (std::fflush(stdout) != 0) throw std::runtime_error("standard output cannot be written");
}

void tell_written(std::initializer_list<std::string> files) {
  for (const auto& file : files) {
    if (!file.empty()) fmt::print(stderr, "wrote {}\n", file);
  }
}

}  // namespace kusabi::run
