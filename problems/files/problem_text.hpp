// Bytes of a problem file and of all files that it names. One rank reads them, and all ranks
// construct the same structure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace kusabi::problems {

/// Maximum total size of these files, in bytes: a million nodes with their elements.
inline constexpr std::uintmax_t largest_meshes = std::uintmax_t{256} << 20U;

struct ProblemText {
  std::string toml;
  /// Mesh files, included files and matrices, by their paths relative to the problem file's folder.
  std::map<std::string, std::string> meshes;

  /// Serialization for broadcasts between ranks.
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& toml& meshes;
  }
};

/// Reads a problem file and the files that it names.
/// @throws InputError if one cannot be read or is too large
ProblemText problem_text(const std::filesystem::path& file);

/// Reads a deck of Abaqus or CalculiX, without a problem file, and the files that it includes;
/// their paths are relative to its folder.
/// @throws InputError as above
ProblemText deck_text(const std::filesystem::path& file);

}  // namespace kusabi::problems
