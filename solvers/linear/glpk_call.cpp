// GLPK calls with captured output and without abort().
#include "solvers/linear/glpk_call.hpp"

#include <cmath>
#include <csetjmp>
#include <cstddef>

#include <glpk.h>

namespace kusabi::linear {
namespace {

// The GLPK environment of a thread.
struct GlpkEnvironment {
  unsigned number = 1;
  bool hooked = false;
  bool calling = false;
  std::string messages;
  std::jmp_buf way_out = {};
};

int glpk_status(BasisStatus place) {
  return place == BasisStatus::basic ? GLP_BS : place == BasisStatus::lower ? GLP_NL : GLP_NU;
}

BasisStatus place_of(int status) {
  return status == GLP_BS   ? BasisStatus::basic
         : status == GLP_NU ? BasisStatus::upper
                            : BasisStatus::lower;
}

GlpkEnvironment& environment() {
  thread_local GlpkEnvironment here;
  return here;
}

extern "C" {
void kusabi_glpk_gave_up(void* info) {
  auto& here = *static_cast<GlpkEnvironment*>(info);
  if (here.calling) std::longjmp(here.way_out, 1);
}

int kusabi_glpk_says(void* info, const char* text) {
  // Called between C frames: nothing may be thrown from here.
  try {
    static_cast<GlpkEnvironment*>(info)->messages += text;
  } catch (...) {
    return 1;
  }
  return 1;  // suppresses the output
}
}

// False if GLPK failed. A function of its own, without objects that longjmp could leave
// undestroyed.
bool survives(GlpkEnvironment& here, const std::function<void()>& call) {
  if (setjmp(here.way_out) != 0) return false;
  call();
  return true;
}

void make(GlpkEnvironment& here, const std::function<void()>& call) {
  if (!here.hooked) {
    glp_term_hook(kusabi_glpk_says, &here);
    glp_error_hook(kusabi_glpk_gave_up, &here);
    here.hooked = true;
  }
  here.messages.clear();
  here.calling = true;
  const bool survived = survives(here, call);
  here.calling = false;
  if (survived) return;
  glp_free_env();
  here.hooked = false;
  ++here.number;
  throw GlpkError("GLPK failed: " + here.messages);
}

}  // namespace

unsigned glpk_environment() {
  return environment().number;
}

void glpk_call(const std::function<void()>& call) {
  auto& here = environment();
  glp_term_out(GLP_OFF);
  make(here, call);
}

std::string glpk_messages_of(const std::function<void()>& call) {
  auto& here = environment();
  glp_term_out(GLP_ON);
  make(here, call);
  return here.messages;
}

int glpk_bound_type(double lower, double upper) {
  if (lower == upper) return GLP_FX;
  if (std::isfinite(lower) && std::isfinite(upper)) return GLP_DB;
  if (std::isfinite(lower)) return GLP_LO;
  if (std::isfinite(upper)) return GLP_UP;
  return GLP_FR;
}

GlpkProblem::GlpkProblem() {
  glpk_call([this] { lp_ = glp_create_prob(); });
  environment_ = glpk_environment();
}

// The objects of a discarded environment are already freed.
GlpkProblem::~GlpkProblem() {
  if (environment_ == glpk_environment()) glp_delete_prob(lp_);
}

void GlpkProblem::call(const std::function<void()>& what) const {
  if (environment_ != glpk_environment()) throw GlpkError("GLPK failed before");
  glpk_call(what);
}

Basis GlpkProblem::basis(int rows, int columns) const {
  Basis basis(static_cast<std::size_t>(rows), static_cast<std::size_t>(columns));
  for (int i = 0; i < rows; ++i) {
    basis.set_row(static_cast<std::size_t>(i), place_of(glp_get_row_stat(lp_, i + 1)));
  }
  for (int j = 0; j < columns; ++j) {
    basis.set_column(static_cast<std::size_t>(j), place_of(glp_get_col_stat(lp_, j + 1)));
  }
  return basis;
}

void GlpkProblem::set_basis(const Basis& basis, int rows, int columns) const {
  call([&] {
    for (int i = 0; i < rows; ++i) {
      const auto at = static_cast<std::size_t>(i);
      glp_set_row_stat(lp_, i + 1, at < basis.rows() ? glpk_status(basis.row(at)) : GLP_BS);
    }
    for (int j = 0; j < columns; ++j) {
      glp_set_col_stat(lp_, j + 1, glpk_status(basis.column(static_cast<std::size_t>(j))));
    }
  });
}

}  // namespace kusabi::linear
