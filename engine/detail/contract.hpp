// Contracts of the engine and of its callers, checked in every build.
//
// Checks that are cheap compared with the guarded work stay enabled in Release. A violation ends
// the search with the condition and its source location, instead of a wrong answer or a crash
// elsewhere.
#pragma once

#include <stdexcept>

namespace kusabi::engine {

/// A contract violated by the engine or its caller: a defect of the program, not of its input.
class ContractBroken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws ContractBroken
[[noreturn]] void contract_broken(const char* promise, const char* file, int line);

/// Checks a contract.
/// @param promise the condition, as a sentence
/// @param file, line source location of the caller (clang 14 lacks std::source_location)
/// @throws ContractBroken with the sentence and the location
constexpr void ensure(bool kept, const char* promise, const char* file = __builtin_FILE(),
                      int line = __builtin_LINE()) {
  if (!kept) [[unlikely]]
    contract_broken(promise, file, line);
}

}  // namespace kusabi::engine
