// The entry of libFuzzer (clang): KUSABI_FUZZ_READER names the reader that is fuzzed; see
// docs/fuzzing.md.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "readers.hpp"

using kusabi::fuzz::Reader;

namespace {

Reader chosen_reader() {
  const char* name = std::getenv("KUSABI_FUZZ_READER");
  const auto reader = kusabi::fuzz::reader_named(name == nullptr ? "" : name);
  if (!reader) {
    std::fputs(
        "KUSABI_FUZZ_READER: expected structure, gmsh, abaqus, matrix, mps, lp, certificate or "
        "checkpoint\n",
        stderr);
    std::exit(2);
  }
  return *reader;
}

const Reader reader = chosen_reader();

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximum);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maximum, unsigned /*seed*/) {
  const auto now = LLVMFuzzerMutate(data, size, maximum);
  std::string bytes(data, data + now);
  kusabi::fuzz::repair(reader, bytes);
  if (bytes.size() > maximum) return now;
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

// A Defect is not caught, and libFuzzer keeps the input that caused it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kusabi::fuzz::try_reader(reader, {data, data + size});
  return 0;
}
