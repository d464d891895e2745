// Data of the program from the model.
#include "nodes/limit/splitting/affine_program.hpp"

namespace kusabi::limit::splitting {

AffineProgram affine_program(const problems::LimitModel& model, double alpha) {
  AffineProgram program;
  std::vector<Eigen::Triplet<double>> entries;
  const int members = model.member_count();
  for (int i = 0; i < members; ++i) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
      entries.emplace_back(static_cast<int>(entry.row()), i, entry.value());
    }
  }
  for (int k = 0; k < model.free_count(); ++k) {
    if (model.reference(k) != 0) entries.emplace_back(k, members, -model.reference(k));
  }
  program.equilibrium.resize(model.free_count(), members + 1);
  program.equilibrium.setFromTriplets(entries.begin(), entries.end());
  program.capacity = model.yield();
  program.shift = (model.tension - model.compression) / 2;
  program.dead = model.dead - model.equilibrium * program.shift;
  SparseLoad dead;
  for (int k = 0; k < model.free_count(); ++k) {
    if (program.dead(k) != 0) dead.emplace_back(k, program.dead(k));
  }
  program.columns.push_back(std::move(dead));
  for (const auto& column : model.uncertain) {
    SparseLoad load;
    for (const auto& [degree, value] : column.direction) {
      load.emplace_back(degree, alpha * column.reach() * value);
    }
    program.columns.push_back(load);
    program.loads.push_back(std::move(load));
  }
  return program;
}

}  // namespace kusabi::limit::splitting
