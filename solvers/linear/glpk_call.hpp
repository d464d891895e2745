// GLPK calls that neither print nor end the process. GLPK reacts to an argument out of range or a
// failed allocation by a message and abort(); its manual permits a hook to leave by longjmp, after
// which its environment must not be used. Such a failure becomes an exception here and the
// environment is discarded; objects of it detect this by glpk_environment().
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "solvers/linear/basis.hpp"

struct glp_prob;  // keeps glpk.h out of this header

namespace kusabi::linear {

/// GLPK failed, or was called with wrong arguments.
class GlpkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Number of GLPK environments that this thread has had. An object made under another number is
/// invalid.
[[nodiscard]] unsigned glpk_environment();

/// Calls GLPK without output. `call` itself must not have objects with a destructor (longjmp skips
/// it), and must not throw.
/// @throws GlpkError if GLPK fails; all GLPK objects of this thread are then invalid
void glpk_call(const std::function<void()>& call);

/// As glpk_call(); returns GLPK's output.
std::string glpk_messages_of(const std::function<void()>& call);

/// GLPK's name of the type of these bounds.
[[nodiscard]] int glpk_bound_type(double lower, double upper);

/// A GLPK problem, valid as long as its environment.
class GlpkProblem {
 public:
  /// An empty one. @throws GlpkError
  GlpkProblem();
  GlpkProblem(const GlpkProblem&) = delete;
  GlpkProblem& operator=(const GlpkProblem&) = delete;
  ~GlpkProblem();

  [[nodiscard]] glp_prob* get() const { return lp_; }
  /// As glpk_call().
  /// @throws GlpkError also if the environment of this problem was discarded
  void call(const std::function<void()>& what) const;

  /// The basis of the first rows and columns.
  [[nodiscard]] Basis basis(int rows, int columns) const;
  /// Rows that the basis does not have become basic.
  void set_basis(const Basis& basis, int rows, int columns) const;

 private:
  glp_prob* lp_ = nullptr;
  unsigned environment_ = 0;
};

}  // namespace kusabi::linear
