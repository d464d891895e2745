// Reader of a structure from a problem file (TOML). docs/problem-files.md describes the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "problems/files/draft/facet_warning.hpp"
#include "problems/structure/checks/checked_structure.hpp"

namespace kusabi::problems {

struct ProblemText;  // problem_text.hpp

/// Maximum size of a problem file, in bytes. A million members take half of it.
inline constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20U;

/// Reads the text of a problem file that names no mesh files. Nodes, members and contact candidates
/// keep the order of the file; normals are normalised.
/// @param file_name name in messages
/// @throws InputError at the first fault of syntax, then at the first fault of `check_structure`
CheckedStructure read_structure(std::string_view toml_text, const std::string& file_name);

/// The same, with the mesh files that the text names.
CheckedStructure read_structure(const ProblemText& text, const std::string& file_name);

/// The same, with data for warnings on normals that depend on the friction coefficient
/// (draft/facet_warning.hpp).
struct StructureAndFacets {
  CheckedStructure structure;
  std::vector<FacetWarning> facets;
};
StructureAndFacets read_structure_and_facets(const ProblemText& text, const std::string& file_name);

/// The text of a file named by the user, or of the standard input: "-".
/// @param expected text of the message if there is none
/// @param largest in bytes
/// @throws InputError if it cannot be read or is larger
std::string file_text(const std::filesystem::path& file,
                      std::string_view expected = "a problem file in TOML",
                      std::uintmax_t largest = largest_file);

/// `read_structure` of `problem_text`.
CheckedStructure load_structure(const std::filesystem::path& file);

}  // namespace kusabi::problems
