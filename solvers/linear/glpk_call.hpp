// Calls of GLPK that do not print and do not end the process. GLPK answers an argument out of range
// or a failed allocation by printing and abort(); its manual allows a hook to leave by longjmp,
// after which nothing of its environment may be used again. So such a failure becomes an exception
// here, the environment is thrown away, and an object that still holds something of it sees by the
// count below that it is gone.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace kusabi::linear {

/// GLPK gave up, or was called wrongly.
class GlpkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Counts the environments that this thread has had; see GlpkError.
[[nodiscard]] unsigned glpk_environment();

/// Makes a call of GLPK, which prints nothing. Nothing with a destructor may live in `call` itself
/// (longjmp skips it), and it must not throw.
/// @throws GlpkError if GLPK gives up; whatever this thread had of GLPK is gone then
void glpk_call(const std::function<void()>& call);

/// The same for a call whose messages matter: what GLPK would have printed comes back.
std::string glpk_messages_of(const std::function<void()>& call);

}  // namespace kusabi::linear
