// Beginnings and ends of sections.
#include "problems/files/meshes/gmsh_sections.hpp"

#include <fmt/format.h>

namespace kusabi::problems {

int read_gmsh_version(MeshText& text) {
  if (!text.next_line() || text.fields() == 0 || text.field(0) != "$MeshFormat") {
    text.fail("the file does not begin with $MeshFormat; expected a mesh of Gmsh");
  }
  next_data(text, "the version");
  const double version = text.real(0, "the version");
  if (text.whole(1, "the kind of file", 0) != 0) {
    text.fail(1, "a file of another kind; expected 0 (ASCII) or 1 (binary)");
  }
  if (version != 2.2 && version != 4.1) {
    text.fail(0, fmt::format("version {:g} of the MSH format; expected 2.2 or 4.1, as Gmsh writes "
                             "with -format msh22 or msh41",
                             version));
  }
  end_section(text, "$MeshFormat");
  return version == 2.2 ? 2 : 4;
}

void skip_section(MeshText& text, const std::string& name) {
  const std::string last = "$End" + name.substr(1);
  while (text.next_line()) {
    if (text.fields() == 1 && text.field(0) == last) return;
  }
  text.fail(fmt::format("the file ends; expected {}", last));
}

void end_section(MeshText& text, const std::string& name) {
  const std::string last = "$End" + name.substr(1);
  if (!text.next_line()) text.fail(fmt::format("the file ends; expected {}", last));
  if (text.fields() != 1 || text.field(0) != last) {
    text.fail(fmt::format("{} continues; expected {}", name, last));
  }
}

void next_data(MeshText& text, std::string_view expected) {
  if (!text.next_line()) text.fail(fmt::format("the file ends; expected {}", expected));
  if (text.fields() > 0 && text.field(0).starts_with('$')) {
    text.fail(0, fmt::format("the section ends; expected {}", expected));
  }
}

}  // namespace kusabi::problems
