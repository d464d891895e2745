// What --vtu DIR writes: a VTU file for each answer, and a PVD file by which ParaView opens them
// all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/vtu/unstructured_grid.hpp"
#include "run/output/output_folder.hpp"

namespace kusabi::run {

/// More files than that nobody looks at: --vtu writes the first of them.
inline constexpr std::size_t longest_series = 1000;

class VtuSeries {
 public:
  explicit VtuSeries(OutputFolder& folder) : folder_(folder) {}

  /// Writes the next one. @throws as OutputFolder
  void add(const std::string& file, const pictures::UnstructuredGrid& grid);

  /// Writes the PVD file, which lists them all: time 1, 2, …
  void finish(const std::string& file, const std::string& remark);

 private:
  OutputFolder& folder_;
  std::vector<pictures::SeriesEntry> entries_;
};

/// "pattern-07.vtu", in a series that has `count` of them.
std::string numbered_vtu(const std::string& stem, std::size_t number, std::size_t count);

/// What is said if there are more than the longest series has; else empty.
/// @param things "rays"
std::string series_remark(std::size_t count, const std::string& things);

}  // namespace kusabi::run
