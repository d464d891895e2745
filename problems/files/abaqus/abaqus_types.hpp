// Element types of Abaqus and CalculiX: their shapes, and the types that stand for others.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

struct AbaqusType {
  enum class Use {
    read,
    left_out,  ///< springs, masses, connectors: no part of the body
    refused,
  };
  Use use = Use::refused;
  MeshShape shape = MeshShape::point;
  std::optional<PlaneState> state;
  /// The type with full integration and the same nodes that is read instead ("C3D8" for "C3D8R");
  /// empty if it is the type itself.
  std::string_view instead;
};

/// @param name in capitals
AbaqusType abaqus_type(std::string_view name);

/// The types that are read, for messages.
std::string abaqus_types_read();

}  // namespace kusabi::problems
