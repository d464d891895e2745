// Parts of an Abaqus file and their instances in the assembly: *PART, *ASSEMBLY, *INSTANCE.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include <Eigen/Geometry>

#include "problems/files/abaqus/abaqus_model.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"

namespace kusabi::problems {

class AbaqusParts {
 public:
  /// The part whose keywords are being read; outside of parts the assembly.
  AbaqusModel& current() { return part_ == nullptr ? assembly_ : *part_; }
  AbaqusModel& assembly() { return assembly_; }

  /// @return false if the keyword is none of *PART, *ASSEMBLY, *INSTANCE and their ends
  bool read(AbaqusText& text, const AbaqusCard& card);

  /// @throws InputError if a part or an instance does not end
  void finish(const AbaqusText& text) const;

 private:
  void begin_part(AbaqusText& text, const AbaqusCard& card);
  void begin_instance(AbaqusText& text, const AbaqusCard& card);
  void end_instance();

  AbaqusModel assembly_;
  std::map<std::string, std::unique_ptr<AbaqusModel>, std::less<>> parts_;  // by name in capitals
  AbaqusModel* part_ = nullptr;
  bool in_instance_ = false;
  std::size_t copies_ = 0;      // entries of all instances
  std::size_t first_node_ = 0;  // of the instance being read
  Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
};

}  // namespace kusabi::problems
