// Supports of an Abaqus file: *BOUNDARY with zero displacements.
#pragma once

#include "problems/files/abaqus/abaqus_model.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"

namespace kusabi::problems {

class AbaqusSupports {
 public:
  /// Adds the supports to the mesh of the part. Displacements that are not zero, and rotations, are
  /// left out.
  void read_boundary(AbaqusText& text, const AbaqusCard& card, AbaqusModel& part);
  /// The first OP=NEW of a step removes all supports before it.
  void begin_step() { cleared_ = false; }

 private:
  bool cleared_ = false;
};

/// Marks nodes whose supports have turned axes.
void read_transform(AbaqusText& text, const AbaqusCard& card, AbaqusModel& part);

/// Makes one support for each node, in the order of the nodes. Supports of nodes with turned axes
/// are left out unless they fix all axes.
void unite_supports(AbaqusText& text, MeshData& mesh);

}  // namespace kusabi::problems
