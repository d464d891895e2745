// `kusabi example`: problem files of the families that the searches are measured on.
#pragma once

#include <string>

#include "problems/families/plane_truss.hpp"
#include "problems/families/space_truss.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct ExampleSpaceTrussOptions {
  problems::SpaceTrussSize size;
  std::string output;  ///< a file; empty: standard output
};

struct ExamplePlaneTrussOptions {
  problems::PlaneTrussSize size;
  std::string output;  ///< a file; empty: standard output
};

/// Writes a plane truss. @return the exit code
/// @throws WrongInput if the size is out of range or the file cannot be written
int example_plane_truss(Session& session, const ExamplePlaneTrussOptions& options);

/// Writes a space truss. @return the exit code
/// @throws WrongInput if the size is out of range or the file cannot be written
int example_space_truss(Session& session, const ExampleSpaceTrussOptions& options);

struct ExampleGridOptions {
  int bays = 0;        ///< along each axis
  std::string output;  ///< as above
};

/// Writes a grid truss. @return the exit code
/// @throws WrongInput as above
int example_grid(Session& session, const ExampleGridOptions& options);

}  // namespace kusabi::run
