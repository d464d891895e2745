// Minus the form has a least eigenvalue that is larger than the effect of all errors.
#include "verify/wedged/form_proof.hpp"

#include <utility>
#include <vector>

#include "verify/wedged/form_matrix.hpp"

namespace kusabi::verify {
namespace {

FormNumbers parts_of_form(std::span<const double> numbers, std::size_t m, std::size_t d) {
  return {numbers.first(m * m), numbers.subspan(m * m, m * m * (d - 1)),
          numbers.subspan(m * m * d, m), numbers.subspan(m * m * d + m)};
}

/// Rigid-body motions in a form, for springs on as many normals as possible.
struct MotionsOfForm {
  std::vector<ApproximateList> lifting;  ///< those of springs on normals
  Dyadic lifted_by_sliding;  ///< bound of the normal displacements by the others, over |u| s / |r|
};

// u - F_P r = sum_j a_j G b_j with a_j = l_j u_j and l_j G_j b_k = [j = k] at the springs j.
std::optional<MotionsOfForm> motions_of_form(const BlockModel& model,
                                             const RegularisedStiffness& regularised) {
  const auto& block = model.block();
  const auto d = block.dimension;
  const auto& springs = regularised.springs();
  std::vector<Rationals> rows;
  rows.reserve(springs.size());
  for (const auto spring : springs) rows.push_back(block.motions.rows[spring]);
  const auto inverse = inverse_columns(std::move(rows));
  if (!inverse) return {};
  MotionsOfForm result;
  for (std::size_t j = 0; j < springs.size(); ++j) {
    const auto& shares = (*inverse)[j];
    auto seen = restricted_to_candidates(block.motions, shares);
    if (springs[j] % d == 0) {
      result.lifting.push_back(std::move(seen));
      continue;
    }
    Dyadic sum;
    for (std::size_t row = 0; row < d * model.candidates(); row += d)
      if (sgn(dot(block.motions.rows[row], shares)) != 0)
        sum = sum + square(absolute(seen.values[row]) + seen.error);
    const auto length = block.motions.lengths[springs[j]] * (Dyadic(1.0) + block.motions.spread);
    result.lifted_by_sliding =
        result.lifted_by_sliding +
        quotient_above(length * sqrt_above(sum), *regularised.min_eigenvalue());
  }
  return result;
}

}  // namespace

// Proves that minus the form has a least eigenvalue larger than the effect of all errors.
ProofResult prove_by_form(const BlockModel& model, std::span<const double> numbers) {
  const auto m = model.candidates();
  const auto& block = model.block();
  const auto d = block.dimension;
  const auto form = parts_of_form(numbers, m, d);
  if (!form.has_allowed_signs())
    return {"a multiplier of two candidates is below zero, or one of squares not above"};
  const auto& stiffness =
      model.regularised(model.grounding(support::IndexSet::below(static_cast<int>(m))).springs);
  if (!stiffness.min_eigenvalue()) return {"K is too ill-conditioned to compute its displacements"};
  std::vector<std::size_t> normals;
  for (std::size_t i = 0; i < m; ++i) normals.push_back(d * i);
  const auto inverse = stiffness.inverse_columns(normals);
  const auto moving = motions_of_form(model, stiffness);
  if (!inverse || !moving) return {"K is too ill-conditioned to compute its displacements"};
  auto rows = normal_rows(*inverse, moving->lifting, m, d);
  const bool far = moving->lifted_by_sliding.sign() > 0;
  rows.error = rows.error + Dyadic(largest_displacement_ratio) * moving->lifted_by_sliding;
  FormMatrix matrix(form, rows, d);
  matrix.add_friction(form, model.friction(), d);
  std::vector<ApproximateList> motions_of_block;
  const Elimination all(model.motions());
  for (const auto& motion : all.basis())
    motions_of_block.push_back(restricted_to_candidates(block.motions, motion));
  if (!matrix.restrict_to_equilibrium(motions_of_block))
    return {"its numbers are too large to compute with"};
  const auto minimum = matrix.min_opposite();
  if (!minimum || !(*minimum > matrix.error())) return {"its form is not negative definite"};
  return {{}, far};
}

}  // namespace kusabi::verify
