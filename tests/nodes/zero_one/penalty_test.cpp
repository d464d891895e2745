// Mixed programs with penalties of up to 1e12 beside prices, compared with rational arithmetic:
// optimal and infeasible programs are recognised.
//
// KUSABI_PENALTY_PROGRAMS and KUSABI_PENALTY_SEED in the environment set the number of programs and
// the first one.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "exact_optimum.hpp"
#include "nodes/zero_one/tree.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {
namespace {

using linear::infinity;
using linear::MixedProgram;
using tests::exact_optimum;

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::stoul(text));
}

class Draw {
 public:
  explicit Draw(unsigned seed) : draw_(seed) {}

  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(draw_); }
  bool one_in(int many) { return whole(1, many) == 1; }
  // A cost with two decimal places, which is not a double.
  double price(int from, int to) {
    return whole(from, to) + (one_in(2) ? whole(1, 99) / 100.0 : 0);
  }
  // A coefficient of a row, whose sums should not be equal up to rounding: quarters, or numbers
  // with many digits.
  double quarters(int from, int to) {
    return whole(from, to) + (one_in(2) ? whole(1, 3) / 4.0 : 0);
  }
  double digits(int from, int to) {
    return std::uniform_real_distribution<double>(from, to)(draw_);
  }
  double penalty() { return std::pow(10.0, whole(3, 12)); }

 private:
  std::mt19937 draw_;
};

// Rows with slack variables at a penalty, or without.
MixedProgram penalised(unsigned seed) {
  Draw draw(seed);
  MixedProgram mixed;
  auto& program = mixed.program;
  const int binaries = draw.whole(2, 6);
  const int continuous = draw.whole(0, 2);
  for (int k = 0; k < binaries; ++k) {
    mixed.binaries.push_back(program.add_column({.cost = draw.price(-5, 30), .upper = 1}));
  }
  for (int j = 0; j < continuous; ++j) {
    const bool bounded = draw.one_in(2);
    program.add_column({.cost = draw.price(bounded ? -9 : 0, 9),
                        .lower = draw.one_in(4) ? -draw.quarters(0, 5) : 0,
                        .upper = bounded ? draw.quarters(0, 8) : infinity});
  }
  if (draw.one_in(3)) program.constant = draw.price(-20, 20);
  const int slacks = 4 - continuous;
  int used = 0;
  const int rows = draw.whole(1, 5);
  const double shared = draw.penalty();
  for (int i = 0; i < rows; ++i) {
    std::vector<linear::LinearTerm> terms;
    const bool many_digits = draw.one_in(3);
    double middle = 0;
    for (int j = 0; j < binaries + continuous; ++j) {
      if (draw.one_in(3)) continue;
      double value = many_digits ? draw.digits(-9, 25) : draw.quarters(-9, 25);
      if (draw.one_in(8)) value = 1e4 * draw.whole(1, 9);
      terms.push_back({j, value});
      middle += value * draw.whole(0, 2) / 2;
    }
    const double right = many_digits ? middle + draw.digits(-3, 3) : middle;
    const double cost = draw.one_in(2) ? shared : draw.penalty();
    if (used < slacks && !draw.one_in(4)) {
      terms.push_back({program.add_column({.cost = cost}), 1});
      ++used;
    }
    if (used < slacks && draw.one_in(2)) {
      terms.push_back({program.add_column({.cost = draw.one_in(2) ? cost : draw.penalty()}), -1});
      ++used;
    }
    const int kind = draw.whole(0, 3);
    program.add_row({.lower = kind == 1   ? -infinity
                              : kind == 3 ? right - draw.quarters(1, 5)
                                          : right,
                     .upper = kind == 2 ? infinity : right},
                    terms);
  }
  return mixed;
}

struct Way {
  ZeroOneRootOptions root;
  ZeroOneBranching branching;
};

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const auto cuts : {ZeroOneCuts::none, ZeroOneCuts::disjunctive}) {
    for (const bool tighten : {true, false}) {
      for (const auto branching : {ZeroOneBranching::paper, ZeroOneBranching::look_ahead}) {
        all.push_back({{.cuts = cuts, .tighten = tighten, .dive = tighten}, branching});
      }
    }
  }
  return all;
}

// True if each row is satisfied to 1e-12 of its terms, each bound and binary exactly.
bool holds(const MixedProgram& mixed, const std::vector<double>& values) {
  const auto& program = mixed.program;
  std::vector<mpq_class> sums(program.rows.size());
  std::vector<mpq_class> sizes(program.rows.size());
  for (const auto& [row, column, value] : program.entries) {
    const mpq_class term = mpq_class(value) * mpq_class(values[static_cast<std::size_t>(column)]);
    sums[static_cast<std::size_t>(row)] += term;
    sizes[static_cast<std::size_t>(row)] += abs(term);
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto& [lower, upper, name] = program.rows[i];
    const mpq_class maximum = sizes[i] / mpq_class(1e12);
    if (std::isfinite(lower) && sums[i] < mpq_class(lower) - maximum) return false;
    if (std::isfinite(upper) && sums[i] > mpq_class(upper) + maximum) return false;
  }
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (values[j] < program.columns[j].lower || values[j] > program.columns[j].upper) return false;
  }
  return std::all_of(mixed.binaries.begin(), mixed.binaries.end(), [&](int column) {
    const double value = values[static_cast<std::size_t>(column)];
    return value == 0 || value == 1;
  });
}

enum class Said { optimal, infeasible, open };

Said check(const MixedProgram& mixed, const tests::ExactOptimum& truth, const Way& way) {
  ZeroOneTree tree(prepare_root(mixed, way.root), way.branching);
  engine::Options options;
  options.goal = engine::Goal::best;
  const auto outcome = engine::search(tree, options);
  const auto& tally = outcome.ranks[0].tally;
  const double bound = tree.lower_bound(outcome.bound, tally);
  if (truth.value && tree.proves()) {
    EXPECT_TRUE(bound == -infinity || mpq_class(bound) <= *truth.value)
        << bound << " is proved, but the optimum is " << truth.value->get_d();
  }
  if (outcome.solutions.empty()) {
    if (tally.unproved != 0) return Said::open;
    EXPECT_FALSE(truth.value.has_value()) << "not infeasible: " << truth.value->get_d();
    return Said::infeasible;
  }
  const auto& point = outcome.solutions[0].solution;
  EXPECT_TRUE(holds(mixed, point.values));
  const double size = std::abs(point.objective);
  constexpr double tolerance = 1e-8;
  if (!truth.value) {
    ADD_FAILURE() << "a point of a program that has none: " << point.objective;
    return Said::open;
  }
  if (!(point.objective - bound <= tolerance * size)) return Said::open;
  EXPECT_LE(abs(mpq_class(point.objective) - *truth.value), mpq_class(tolerance * size))
      << point.objective << " for " << truth.value->get_d();
  return Said::optimal;
}

TEST(ZeroOneTree, SolvesProgramsWithLargePenalties) {
  const unsigned programs = from_environment("KUSABI_PENALTY_PROGRAMS", 120);
  const unsigned first = from_environment("KUSABI_PENALTY_SEED", 1);
  const auto all = ways();
  int optimal = 0;
  int infeasible = 0;
  int open = 0;
  for (unsigned seed = first; seed < first + programs; ++seed) {
    const auto mixed = penalised(seed);
    const auto truth = exact_optimum(mixed);
    if (truth.unbounded) continue;
    for (std::size_t w = 0; w < all.size(); ++w) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " way " << w);
      switch (check(mixed, truth, all[w])) {
        case Said::optimal:
          ++optimal;
          break;
        case Said::infeasible:
          ++infeasible;
          break;
        case Said::open:
          ++open;
          std::printf("open: seed %u way %zu\n", seed, w);
          break;
      }
    }
  }
  std::printf("%d optimal, %d infeasible, %d open\n", optimal, infeasible, open);
  EXPECT_GT(optimal, static_cast<int>(programs));
  EXPECT_GT(infeasible, 0);
  EXPECT_EQ(open, 0);
}

}  // namespace
}  // namespace kusabi::zero_one
