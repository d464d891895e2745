// A wheel on a pin that fits into a round housing: spokes, rim bars and radial normals. Its rotation
// is tangential at each candidate, but in the file's coordinates only up to rounding.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "problems/files/structure_file.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::wedged::testing {

/// @param turn angle of the first spoke, which only changes the axes
inline problems::Structure wheel(int spokes, double turn) {
  std::string text =
      "name = \"wheel\"\ndimension = 2\nunits = { length = \"m\", force = \"kN\" }\n"
      "[nodes]\no = [0, 0]\n";
  std::string bars;
  std::string contact;
  for (int k = 0; k < spokes; ++k) {
    const double angle = turn + 2 * std::numbers::pi * k / spokes;
    const double x = std::cos(angle), y = std::sin(angle);
    text += fmt::format("p{} = [{}, {}]\n", k, x, y);
    bars += fmt::format("[\"o\", \"p{0}\"], [\"p{0}\", \"p{1}\"], ", k, (k + 1) % spokes);
    contact += fmt::format("[[contact]]\nnodes = [\"p{}\"]\nnormal = [{}, {}]\n", k, -x, -y);
  }
  text += fmt::format("[[members]]\nEA = 1\nbetween = [{}]\n[[supports]]\nnodes = [\"o\"]\n", bars);
  return problems::read_structure(text + contact, "wheel.toml");
}

}  // namespace kusabi::wedged::testing
