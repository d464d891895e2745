// The materials of an Abaqus file, and which elements are of them: *MATERIAL, *ELASTIC and
// *SOLID SECTION.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/files/meshes/abaqus_groups.hpp"
#include "problems/files/meshes/abaqus_text.hpp"
#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

class AbaqusMaterials {
 public:
  AbaqusMaterials(MeshData& mesh, const AbaqusGroups& groups) : mesh_(mesh), groups_(groups) {}

  void read_material(AbaqusText& text, const AbaqusCard& card);
  void read_elastic(AbaqusText& text, const AbaqusCard& card);
  void read_section(AbaqusText& text, const AbaqusCard& card);

  /// Gives the sections of the mesh their materials, which may stand below them.
  void finish();

 private:
  /// Without elasticity until that is read.
  struct Material {
    double modulus = 0;
    double ratio = 0;
    bool elastic = false;
  };

  MeshData& mesh_;
  const AbaqusGroups& groups_;
  std::map<std::string, Material, std::less<>> materials_;  // by name in capitals
  Material* latest_ = nullptr;                              // that *ELASTIC speaks of
  std::vector<std::string> names_;                          // of the material of each section
  std::vector<bool> has_section_;                           // one an element
};

}  // namespace kusabi::problems
