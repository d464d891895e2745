// The banner, comments, the size, the numbers.
#include "problems/files/matrix_market.hpp"

#include <iomanip>
#include <ostream>

namespace kusabi::problems {

void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix,
                         std::span<const std::string> comments) {
  constexpr int all_digits = 17;
  out << "%%MatrixMarket matrix array real symmetric\n";
  for (const auto& line : comments) out << "% " << line << '\n';
  out << matrix.rows() << ' ' << matrix.cols() << '\n' << std::setprecision(all_digits);
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    for (Eigen::Index row = column; row < matrix.rows(); ++row) out << matrix(row, column) << '\n';
  }
}

}  // namespace kusabi::problems
