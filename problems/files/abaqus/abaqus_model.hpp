// Part, or assembly, of an Abaqus file while it is read; a file without parts is one assembly.
#pragma once

#include "problems/files/abaqus/abaqus_groups.hpp"
#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_index.hpp"

namespace kusabi::problems {

struct AbaqusModel {
  MeshData mesh;
  MeshIndex index{mesh};
  AbaqusGroups groups{mesh, index};

  AbaqusModel() = default;
  AbaqusModel(const AbaqusModel&) = delete;  // its members refer to each other
  AbaqusModel& operator=(const AbaqusModel&) = delete;
};

}  // namespace kusabi::problems
