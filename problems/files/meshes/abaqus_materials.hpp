// Materials of an Abaqus file and their elements: *MATERIAL, *ELASTIC and *SOLID SECTION.
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

  /// Assigns the materials to the sections of the mesh; materials may follow sections in the file.
  void finish();

 private:
  /// Without elastic constants until *ELASTIC is read.
  struct Material {
    double modulus = 0;
    double ratio = 0;
    bool elastic = false;
  };

  MeshData& mesh_;
  const AbaqusGroups& groups_;
  std::map<std::string, Material, std::less<>> materials_;  // by name in capitals
  Material* latest_ = nullptr;                              // material of the next *ELASTIC
  std::vector<std::string> names_;                          // material names of the sections
  std::vector<bool> has_section_;                           // by element
};

}  // namespace kusabi::problems
