// Pairs of surfaces of a deck as [[ties]] and [[contact]].
#pragma once

#include <optional>

#include "problems/files/decks/deck_draft.hpp"

namespace kusabi::problems {

/// Writes the ties, then the contact candidates: the nodes of the first surface of each pair that
/// touch the second one.
/// @param gap distance that counts as touching in all pairs; nothing: that of the deck, or of
///        problem files
void write_pairs(DeckDraft& draft, std::optional<double> gap);

/// The largest friction coefficient of the contact pairs; 0 if none has one.
double largest_friction(const MeshData& mesh);

}  // namespace kusabi::problems
