// Faces of meshed blocks with many candidates, on which branching rules differ.
#pragma once

#include <string>

#include <fmt/format.h>

#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// A block with a supported left side. @param contact the section's lines
inline problems::WedgedProblem face(const std::string& corners, const std::string& divisions,
                                    const std::string& contact) {
  return problems::wedged_problem(problems::read_structure(
      fmt::format("name = \"face\"\ndimension = 2\nunits = {{ length = \"m\", force = \"kN\" }}\n"
                  "[[mesh]]\nname = \"b\"\ncorners = {}\ndivisions = {}\nE = 1\nnu = 0.3\n"
                  "thickness = 1\nplane = \"stress\"\n[[supports]]\nnodes = [\"b.left\"]\n"
                  "[[contact]]\n{}\n",
                  corners, divisions, contact),
      "face.toml"));
}

/// All nodes of the lower side are in contact. Its critical coefficient is near 5.3.
inline problems::WedgedProblem cantilever_face(int candidates) {
  return face("[[0, 0], [4, 0], [4, 1], [0, 1]]", fmt::format("[{}, 4]", candidates),
              "nodes = [\"b.bottom\"]\nexcept = [\"b.left\"]\nnormal = [0, 1]");
}

/// The side opposite to the supported one, with normals that lean by 11 degrees towards it.
inline problems::WedgedProblem leaning_face(int candidates) {
  return face("[[0, 0], [1.8, 0], [2, 2], [0, 2]]", fmt::format("[4, {}]", candidates - 1),
              "nodes = [\"b.right\"]\nnormal = [-2.0, -0.2]");
}

}  // namespace kusabi::wedged
