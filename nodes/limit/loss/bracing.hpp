// Members that brace a stress state: the equilibrium errors of rounded forces are carried by
// corrections of the forces, which exist for any error only if the members are no mechanism. The
// stressed members of a basic solution may be one, such as two bars in line.
#pragma once

#include "problems/limit/limit_analysis.hpp"
#include "support/index_set.hpp"

namespace kusabi::limit {

/// The stressed members with as few others as make B of the displacements of their nodes, with the
/// column f_R, of full row rank, as far as members between these nodes and the ground can.
/// @param available members to be chosen from @param preferred the first to be chosen
support::IndexSet braced(const problems::LimitModel& model, const support::IndexSet& stressed,
                         const support::IndexSet& available, const support::IndexSet& preferred);

}  // namespace kusabi::limit
