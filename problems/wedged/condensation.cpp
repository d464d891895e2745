// Static condensation with sparse Cholesky factorisations.
#include "problems/wedged/condensation.hpp"

#include <cstddef>

#include <Eigen/SparseCholesky>

namespace kusabi::problems {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The stiffness cut into the blocks of equation (2). K_NC is dense: it has few columns.
struct Blocks {
  Eigen::MatrixXd contact;          ///< K_CC
  Eigen::MatrixXd rest_to_contact;  ///< K_NC
  SparseMatrix rest;                ///< K_NN
};

/// Number of each free displacement within its own block: contact ones below zero as -1 - place.
std::vector<int> numbers_in_blocks(int size, const std::vector<int>& places) {
  std::vector<int> number(static_cast<std::size_t>(size), 0);
  int place = 0;
  for (const int contact : places) number[static_cast<std::size_t>(contact)] = -1 - place++;
  int rest = 0;
  for (int& entry : number) {
    if (entry >= 0) entry = rest++;
  }
  return number;
}

Blocks cut(const SparseMatrix& stiffness, const std::vector<int>& places) {
  const auto contact = static_cast<Eigen::Index>(places.size());
  const Eigen::Index rest = stiffness.rows() - contact;
  const std::vector<int> number = numbers_in_blocks(static_cast<int>(stiffness.rows()), places);
  Blocks blocks{Eigen::MatrixXd::Zero(contact, contact), Eigen::MatrixXd::Zero(rest, contact),
                SparseMatrix(rest, rest)};
  std::vector<Eigen::Triplet<double>> rest_entries;
  for (int outer = 0; outer < stiffness.outerSize(); ++outer) {
    for (SparseMatrix::InnerIterator entry(stiffness, outer); entry; ++entry) {
      const int row = number[static_cast<std::size_t>(entry.row())];
      const int column = number[static_cast<std::size_t>(entry.col())];
      if (row < 0 && column < 0) blocks.contact(-1 - row, -1 - column) = entry.value();
      if (row >= 0 && column < 0) blocks.rest_to_contact(row, -1 - column) = entry.value();
      if (row >= 0 && column >= 0) rest_entries.emplace_back(row, column, entry.value());
    }
  }
  blocks.rest.setFromTriplets(rest_entries.begin(), rest_entries.end());
  return blocks;
}

/// A^-1 B for a symmetric positive definite A; nothing if A is not.
std::optional<Eigen::MatrixXd> solve(const SparseMatrix& matrix, const Eigen::MatrixXd& right) {
  const Eigen::SimplicialLLT<SparseMatrix> factorised(matrix);
  if (factorised.info() != Eigen::Success) return std::nullopt;
  return Eigen::MatrixXd(factorised.solve(right));
}

/// K_CC - K_CN K_NN^-1 K_NC, equation (3).
std::optional<Eigen::MatrixXd> schur_complement(const Blocks& blocks) {
  if (blocks.rest.rows() == 0) return blocks.contact;
  const auto follows = solve(blocks.rest, blocks.rest_to_contact);
  if (!follows) return std::nullopt;
  return Eigen::MatrixXd(blocks.contact - blocks.rest_to_contact.transpose() * *follows);
}

/// Displacements at `places` under unit loads along the `directions`, in the axes.
std::optional<Eigen::MatrixXd> displacements(const SparseMatrix& stiffness,
                                             const std::vector<int>& places,
                                             const Eigen::MatrixXd& directions) {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(stiffness.rows(), directions.cols());
  loads(places, Eigen::all) = directions;
  const auto whole = solve(stiffness, loads);
  if (!whole) return std::nullopt;
  return Eigen::MatrixXd((*whole)(places, Eigen::all));
}

}  // namespace

std::optional<CondensedMatrices> condense(const SparseMatrix& stiffness,
                                          const std::vector<int>& places,
                                          const Eigen::MatrixXd& directions) {
  const auto condensed = schur_complement(cut(stiffness, places));
  const auto displaced = displacements(stiffness, places, directions);
  if (!condensed || !displaced) return std::nullopt;
  return CondensedMatrices{directions.transpose() * *condensed * directions,
                           directions.transpose() * *displaced};
}

}  // namespace kusabi::problems
