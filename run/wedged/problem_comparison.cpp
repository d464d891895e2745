// Hash of the input and of the computed problem; the numbers of rank 0 where it differs.
#include "run/wedged/problem_comparison.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

template <class Matrix>
std::span<const double> doubles_of(const Matrix& matrix) {
  const auto each = sizeof(typename Matrix::Scalar) / sizeof(double);
  return {reinterpret_cast<const double*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * each};
}

// Stiffness and compliance as a list of numbers, after their number of rows.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(const problems::Compliance& compliance) {
    add(compliance.stiffness);
    add(compliance.matrix);
    add(compliance.precise);
    list_.push_back(compliance.error);
    list_.push_back(compliance.precise_error);
  }

  [[nodiscard]] std::uint64_t fingerprint() const {
    support::Fingerprint result;
    for (const double number : list_) result.add(number);
    return result.value();
  }

  void copy_to(problems::Compliance& compliance) const {
    auto next = list_.begin();
    copy(next, compliance.stiffness);
    copy(next, compliance.matrix);
    copy(next, compliance.precise);
    compliance.error = *next++;
    compliance.precise_error = *next;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned) {
    archive& list_;
  }

 private:
  using Place = std::vector<double>::const_iterator;

  template <class Matrix>
  void add(const Matrix& matrix) {
    const auto numbers = doubles_of(matrix);
    list_.push_back(static_cast<double>(matrix.rows()));
    list_.insert(list_.end(), numbers.begin(), numbers.end());
  }

  template <class Matrix>
  static void copy(Place& next, Matrix& matrix) {
    const auto rows = static_cast<Eigen::Index>(*next++);
    matrix.resize(rows, rows);
    const auto count = static_cast<std::ptrdiff_t>(doubles_of(matrix).size());
    std::copy_n(next, count, reinterpret_cast<double*>(matrix.data()));
    next += count;
  }

  std::vector<double> list_;
};

}  // namespace

void make_equal_on_all_ranks(Session& session, problems::WedgedProblem& problem) {
  auto& transport = session.transport();
  engine::require_equal_on_all_ranks(transport, problem.provenance.fingerprint);
  if (transport.size() == 1) return;
  const Numbers own(problem.compliance);
  const auto mark = own.fingerprint();
  const auto first = engine::from_first_rank(transport, [&] { return mark; });
  const auto all = engine::all_reduce(transport, {.ranks = 1, .found = first == mark ? 0U : 1U});
  if (all.found == 0) return;
  engine::from_first_rank(transport, [&] { return own; }).copy_to(problem.compliance);
}

}  // namespace kusabi::run
