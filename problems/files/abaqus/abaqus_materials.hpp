// Materials of an Abaqus file and their elements: *MATERIAL, *ELASTIC, *DENSITY and
// *SOLID SECTION.
#pragma once

#include <map>
#include <string>

#include "problems/files/abaqus/abaqus_model.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

class AbaqusMaterials {
 public:
  void read_material(AbaqusText& text, const AbaqusCard& card);
  void read_elastic(AbaqusText& text, const AbaqusCard& card);
  void read_density(AbaqusText& text);
  /// The section is added to the mesh of the part.
  void read_section(AbaqusText& text, const AbaqusCard& card, AbaqusModel& part) const;

  /// Assigns the materials to the sections of the mesh; materials may follow sections in the file.
  /// @throws InputError if a material does not exist or an element has two sections
  void finish(MeshData& mesh) const;

 private:
  /// Without elastic constants until *ELASTIC is read.
  struct Material {
    double modulus = 0;
    double ratio = 0;
    double density = 0;
    bool read = false;                        ///< an *ELASTIC
    std::string fault = "has no elasticity";  ///< empty with the constants of an isotropic material
  };

  std::map<std::string, Material, std::less<>> materials_;  // by name in capitals
  Material* latest_ = nullptr;                              // material of the next *ELASTIC
};

}  // namespace kusabi::problems
