// Problem file from a deck of Abaqus or CalculiX, with warnings about entries that are left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

struct DeckChoices {
  std::string file;  ///< the deck, as seen from the problem file
  std::string length = "length unit of the deck";
  std::string force = "force unit of the deck";
  std::optional<double> gap;  ///< distance that counts as touching
};

struct DeckProblem {
  std::string text;
  std::vector<std::string> warnings;
};

/// The text of a problem file with the mesh, the materials, the supports, the ties and the contact
/// candidates of the deck.
DeckProblem deck_problem(const MeshData& mesh, const DeckChoices& choices);

}  // namespace kusabi::problems
