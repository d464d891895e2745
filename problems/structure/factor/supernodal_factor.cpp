// CHOLMOD's supernodal factorisation (Chen, Davis, Hager and Rajamanickam 2008) behind Eigen's
// interface.
#include <new>

#include <Eigen/CholmodSupport>

#include "problems/structure/factor/blas_product.hpp"
#include "problems/structure/factor/factor_rows.hpp"
#include "problems/structure/factor/sparse_factor.hpp"

namespace kusabi::problems {
class SparseFactor<double>::Supernodes
    : public Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> {
 public:
  Supernodes() {
    cholmod().print = 0;
    cholmod().quick_return_if_not_posdef = 1;
    cholmod().nmethods = 1;
    // With METIS's separators. Its own ordering (CHOLMOD_METIS) would replace the signal handlers.
    cholmod().method[0].ordering = CHOLMOD_NESDIS;
    cholmod().postorder = 1;
  }

  void factorise(const Eigen::SparseMatrix<double>& matrix, double shift) {
    if (matrix.rows() == 0) return;
    setShift(shift);
    analyzePattern(matrix);
    if (m_cholmodFactor == nullptr) throw std::bad_alloc();
    factorize(matrix);
    if (cholmod().status < 0) throw std::bad_alloc();
  }

  [[nodiscard]] bool exists() const {
    return m_cholmodFactor == nullptr || m_cholmodFactor->minor == m_cholmodFactor->n;
  }

  [[nodiscard]] FactorRows rows() const {
    if (m_cholmodFactor == nullptr) return {};
    return rows_of_factor(static_cast<Eigen::Index>(m_cholmodFactor->n),
                          [this](const auto& use) { for_each_entry(use); });
  }

 private:
  // A supernode has consecutive columns with the same rows, the first of which are its own. The
  // upper triangle among these is not part of L.
  template <class Use>
  void for_each_entry(const Use& use) const {
    const auto list = [](const void* numbers) { return static_cast<const int*>(numbers); };
    const auto& factor = *m_cholmodFactor;
    const int* const rows_of = list(factor.pi);
    for (std::size_t k = 0; k < factor.nsuper; ++k) {
      const int first = list(factor.super)[k];
      const int columns = list(factor.super)[k + 1] - first;
      const int height = rows_of[k + 1] - rows_of[k];
      const int* const rows = list(factor.s) + rows_of[k];
      const double* entries = static_cast<const double*>(factor.x) + list(factor.px)[k];
      for (int column = 0; column < columns; ++column, entries += height) {
        for (int i = column; i < height; ++i) use(rows[i], first + column, entries[i]);
      }
    }
  }
};

SparseFactor<double>::SparseFactor(const Eigen::SparseMatrix<double>& matrix, double shift) {
  use_one_thread();
  supernodes_ = std::make_unique<Supernodes>();
  supernodes_->factorise(matrix, shift);
}

SparseFactor<double>::~SparseFactor() = default;
SparseFactor<double>::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor<double>& SparseFactor<double>::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor<double>::exists() const {
  return supernodes_->exists();
}

void SparseFactor<double>::solve(Matrix& right) const {
  if (right.size() == 0) return;
  right = Matrix(supernodes_->solve(right));
  if (supernodes_->info() != Eigen::Success) throw std::bad_alloc();
}

FactorRows SparseFactor<double>::rows() const {
  return supernodes_->rows();
}

}  // namespace kusabi::problems
