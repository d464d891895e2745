// Files of --vtu DIR: one VTU file per answer, and a PVD file for ParaView that lists them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/vtu/unstructured_grid.hpp"
#include "run/output/output_file.hpp"

namespace kusabi::run {

/// Maximum number of files; --vtu writes the first ones.
inline constexpr std::size_t longest_series = 1000;

class VtuSeries {
 public:
  explicit VtuSeries(OutputFolder& folder) : folder_(folder) {}

  /// Writes the next file. @throws as OutputFolder
  void add(const std::string& file, const pictures::UnstructuredGrid& grid);

  /// Writes a script for ParaView of the same name, then the PVD file, with times 1, 2, …
  void finish(const std::string& file, const std::string& remark);

 private:
  OutputFolder& folder_;
  std::vector<pictures::SeriesEntry> entries_;
};

/// "pattern-07.vtu", in a series of `count` files.
std::string numbered_vtu(const std::string& stem, std::size_t number, std::size_t count);

/// A remark if there are more answers than files; else empty. @param things "rays"
std::string series_remark(std::size_t count, const std::string& things);

}  // namespace kusabi::run
