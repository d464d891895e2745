// Contact and ties of an Abaqus file: *SURFACE INTERACTION, *FRICTION, *CONTACT PAIR, *TIE.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/files/abaqus/abaqus_model.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

class AbaqusContact {
 public:
  /// @return false if the keyword is none of contact
  bool read(AbaqusText& text, const AbaqusCard& card, const AbaqusModel& assembly);

  /// Adds the pairs with the friction of their interactions, which may follow them in the file.
  void finish(AbaqusText& text, MeshData& mesh) const;

 private:
  struct Interaction {
    std::optional<double> friction;
    bool tied = false;
  };
  struct Pair {
    MeshPair pair;
    std::string interaction;  // in capitals; empty: none
  };

  void read_friction(AbaqusText& text, const AbaqusCard& card);
  void read_pairs(AbaqusText& text, const AbaqusCard& card, const AbaqusModel& assembly);

  std::map<std::string, Interaction, std::less<>> interactions_;  // by name in capitals
  Interaction* latest_ = nullptr;
  std::vector<Pair> pairs_;
};

}  // namespace kusabi::problems
