// Loads of an Abaqus file: forces at nodes, *CLOAD, and gravity, *DLOAD.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "problems/files/abaqus/abaqus_model.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"

namespace kusabi::problems {

/// The loads at the end of the last step. Those of a step replace earlier ones of the same node and
/// axis, and add up among each other.
class AbaqusLoads {
 public:
  /// Data lines: NODE OR SET, AXIS, FORCE. Amplitudes are not used. Moments, and forces that follow
  /// the structure, are left out with a warning.
  void read(AbaqusText& text, const AbaqusCard& card, AbaqusModel& assembly);
  void begin_step() { ++step_; }
  /// Adds the loads to the mesh, one for each node. Those of nodes with turned axes are left out.
  void finish(AbaqusText& text, MeshData& mesh) const;

 private:
  struct Component {
    double force = 0;
    int step = 0;
    MeshPlace at{};
  };

  int step_ = 0;
  int cleared_in_ = -1;                                    // step with OP=NEW
  std::map<std::pair<int, int>, Component> components_{};  // by node and axis
};

/// Gravity at the end of the last step. That of a step replaces earlier gravity of the same set,
/// and adds up among itself.
class AbaqusGravity {
 public:
  /// Data lines: SET, GRAV, MAGNITUDE, DIRECTION; without a set all elements. Other distributed
  /// loads are left out with a warning.
  void read(AbaqusText& text, const AbaqusCard& card, AbaqusModel& assembly);
  void begin_step() { ++step_; }
  /// Adds the gravity to the mesh.
  void finish(MeshData& mesh) const;

 private:
  struct Load {
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
    int step = 0;
    MeshPlace at{};
  };

  int step_ = 0;
  int cleared_in_ = -1;                  // step with OP=NEW
  std::map<std::string, Load> loads_{};  // by the name of the set
};

}  // namespace kusabi::problems
