// The bytes of a problem file and of all files that it names. One rank reads them, and all make the
// same structure of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace kusabi::problems {

/// Largest sum of the sizes of all these files, in bytes: a million nodes with their elements.
inline constexpr std::uintmax_t largest_meshes = std::uintmax_t{256} << 20U;

struct ProblemText {
  std::string toml;
  /// Mesh files, what they include, and matrices, by their places relative to the problem file's
  /// folder.
  std::map<std::string, std::string> meshes;

  /// For Boost.Serialization: one rank sends it to the others.
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& toml& meshes;
  }
};

/// Reads a problem file and the files that it names.
/// @throws InputError if one cannot be read or is too large
ProblemText problem_text(const std::filesystem::path& file);

}  // namespace kusabi::problems
