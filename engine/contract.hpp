// What the engine takes for granted of itself and of its callers, checked in every build.
//
// A condition that is cheap beside what it guards stays on in Release: a broken one ends the search
// with the sentence and the place, instead of a wrong answer or a crash elsewhere.
#pragma once

#include <source_location>
#include <stdexcept>

namespace kusabi::engine {

/// A promise that the engine or its caller has broken: a defect of the program, not of its input.
class ContractBroken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws ContractBroken
[[noreturn]] void contract_broken(const char* promise, const std::source_location& place);

/// Goes on if a promise is kept.
/// @param promise what holds, in a sentence
/// @throws ContractBroken with the sentence, file and line
constexpr void ensure(bool kept, const char* promise,
                      const std::source_location& place = std::source_location::current()) {
  if (!kept) [[unlikely]]
    contract_broken(promise, place);
}

}  // namespace kusabi::engine
