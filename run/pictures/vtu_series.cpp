// Files first, then their list, so that it names only existing files.
#include "run/pictures/vtu_series.hpp"

#include <ostream>

#include <fmt/format.h>

#include "run/pictures/paraview_script.hpp"

namespace kusabi::run {

void VtuSeries::add(const std::string& file, const pictures::UnstructuredGrid& grid) {
  folder_.write(file, [&](std::ostream& out) { write_vtu(out, grid); });
  entries_.push_back({file, static_cast<double>(entries_.size() + 1)});
}

void VtuSeries::finish(const std::string& file, const std::string& remark) {
  const auto stem = file.substr(0, file.rfind('.'));
  folder_.write(stem + ".py", [](std::ostream& out) { out << paraview_script; });
  folder_.write(file, [&](std::ostream& out) { write_pvd(out, entries_, remark); });
}

std::string numbered_vtu(const std::string& stem, std::size_t number, std::size_t count) {
  return fmt::format("{}-{:0{}}.vtu", stem, number, std::to_string(count).size());
}

std::string series_remark(std::size_t count, const std::string& things) {
  if (count <= longest_series) return {};
  return fmt::format("--vtu: the first {} of {} {}", longest_series, count, things);
}

}  // namespace kusabi::run
