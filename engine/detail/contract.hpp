// What the engine takes for granted of itself and of its callers, checked in every build.
//
// A condition that is cheap beside what it guards stays on in Release: a broken one ends the search
// with the sentence and the place, instead of a wrong answer or a crash elsewhere.
#pragma once

#include <stdexcept>

namespace kusabi::engine {

/// A promise that the engine or its caller has broken: a defect of the program, not of its input.
class ContractBroken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws ContractBroken
[[noreturn]] void contract_broken(const char* promise, const char* file, int line);

/// Goes on if a promise is kept.
/// @param promise what holds, in a sentence
/// @param file, line of the caller (std::source_location is not for clang 14)
/// @throws ContractBroken with all three
constexpr void ensure(bool kept, const char* promise, const char* file = __builtin_FILE(),
                      int line = __builtin_LINE()) {
  if (!kept) [[unlikely]]
    contract_broken(promise, file, line);
}

}  // namespace kusabi::engine
