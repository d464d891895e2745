// Contacts whose reaction is zero by equilibrium: for an unconstrained body in space with reactions
// at two points, they act along the line between them, and a third point whose friction cone does
// not contain a direction in a plane through this line has none.
#pragma once

#include "support/index_set.hpp"
#include "verify/wedged/block_model.hpp"

namespace kusabi::verify {

/// True if equilibrium makes the reaction of a contact of U zero in all configurations below the
/// node (U, R).
[[nodiscard]] bool leaves_a_contact_unloaded(const BlockModel& model,
                                             const support::IndexSet& contact,
                                             const support::IndexSet& separated);

}  // namespace kusabi::verify
