// Writer of the Conic Benchmark Format: one section per keyword, separated by blank lines.
#include "solvers/conic/benchmark_format.hpp"

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <vector>

namespace kusabi::conic {
namespace {

const char* name_of(ConePart::Kind kind) {
  switch (kind) {
    case ConePart::Kind::free:
      return "F";
    case ConePart::Kind::zero:
      return "L=";
    case ConePart::Kind::nonnegative:
      return "L+";
    case ConePart::Kind::second_order:
      break;
  }
  return "Q";
}

void write_parts(std::ostream& out, const char* keyword, Eigen::Index size,
                 const std::vector<ConePart>& parts) {
  out << keyword << '\n' << size << ' ' << parts.size() << '\n';
  for (const auto& [kind, count] : parts) out << name_of(kind) << ' ' << count << '\n';
  out << '\n';
}

void write_vector(std::ostream& out, const char* keyword, const Eigen::VectorXd& vector) {
  out << keyword << '\n' << (vector.array() != 0).count() << '\n';
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    if (vector(i) != 0) out << i << ' ' << vector(i) << '\n';
  }
  out << '\n';
}

void write_matrix(std::ostream& out, const char* keyword, const Eigen::MatrixXd& matrix) {
  out << keyword << '\n' << (matrix.array() != 0).count() << '\n';
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (matrix(i, j) != 0) out << i << ' ' << j << ' ' << matrix(i, j) << '\n';
    }
  }
  out << '\n';
}

}  // namespace

void write_benchmark_format(std::ostream& out, const ConeProgram& program,
                            std::span<const std::string> comments) {
  constexpr std::size_t longest = 500;
  constexpr int all_digits = 17;
  for (const auto& line : comments) out << "# " << line.substr(0, longest) << '\n';
  out << std::setprecision(all_digits);
  out << "VER\n1\n\nOBJSENSE\nMAX\n\n";
  write_parts(out, "VAR", program.matrix.cols(), program.columns);
  write_parts(out, "CON", program.matrix.rows(), program.rows);
  write_vector(out, "OBJACOORD", program.costs);
  write_matrix(out, "ACOORD", program.matrix);
  write_vector(out, "BCOORD", program.constants);
}

}  // namespace kusabi::conic
