// The interface of Fortran, which every BLAS has.
#include "problems/structure/factor/blas_product.hpp"

// Numbers of threads of OpenBLAS and of OpenMP, which CHOLMOD uses as well; null where neither is
// linked.
extern "C" {
[[gnu::weak]] void openblas_set_num_threads(int number);
[[gnu::weak]] void omp_set_max_active_levels(int number);

// NOLINTNEXTLINE(readability-identifier-naming): the name of a compiler of Fortran
void dgemm_(const char* of_a, const char* of_b, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* a_distance, const double* b,
            const int* b_distance, const double* beta, double* c, const int* c_distance);
}

namespace kusabi::problems {

void use_one_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
  if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
}

Eigen::MatrixXd product_of_columns(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                   const Eigen::Ref<const Eigen::MatrixXd>& b) {
  use_one_thread();
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(a.cols(), b.cols());
  if (product.size() == 0 || a.rows() == 0) return product;
  const auto count = [](Eigen::Index number) { return static_cast<int>(number); };
  const int m = count(a.cols());
  const int n = count(b.cols());
  const int k = count(a.rows());
  const int a_distance = count(a.outerStride());
  const int b_distance = count(b.outerStride());
  const double one = 1;
  const double zero = 0;
  dgemm_("T", "N", &m, &n, &k, &one, a.data(), &a_distance, b.data(), &b_distance, &zero,
         product.data(), &m);
  return product;
}

}  // namespace kusabi::problems
