// UnstructuredGrid: a mesh with point and cell data, and its file: VTU, the XML format of VTK's
// unstructured grid, for ParaView and other readers of VTK.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace kusabi::pictures {

/// Cell types with VTK's numbers.
enum class CellType : std::uint8_t {
  vertex = 1,
  line = 3,
  triangle = 5,
  quadrilateral = 9,
  tetrahedron = 10,
  hexahedron = 12,
  wedge = 13,
  pyramid = 14,
  quadratic_triangle = 22,
  quadratic_quadrilateral = 23,
  quadratic_tetrahedron = 24,
  quadratic_hexahedron = 25,
  quadratic_wedge = 26,
};

struct Cell {
  CellType type;
  std::vector<int> points;  ///< in VTK's order
};

/// Small integers: states, flags. Components x tuples.
using SmallNumbers = Eigen::Matrix<std::int8_t, Eigen::Dynamic, Eigen::Dynamic>;

/// Integers of the user's files: node numbers. Components x tuples.
using WholeNumbers = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic>;

/// A tuple of numbers for each point or each cell, or one for the whole grid. Vectors have three
/// components, also in the plane.
struct Field {
  std::string name;
  std::variant<Eigen::MatrixXd, SmallNumbers, WholeNumbers> values;  ///< components x tuples
  std::string unit{};  ///< VTK's key UNITS_LABEL; empty: none
};

struct UnstructuredGrid {
  std::string remark;       ///< a comment at the head of the file; may be empty
  Eigen::Matrix3Xd points;  ///< third coordinate zero in the plane
  std::vector<Cell> cells;
  std::vector<Field> point_data;
  std::vector<Field> cell_data;
  std::vector<Field> field_data{};  ///< of the whole grid
};

/// Writes the grid as a VTU file; arrays in base64, compressed by zlib if they are large.
/// @pre the fields have a column for each point or cell
void write_vtu(std::ostream& out, const UnstructuredGrid& grid);

/// A file of a time series in ParaView.
struct SeriesEntry {
  std::string file;  ///< relative to the folder of the series file
  double time;
};

/// Writes a PVD file, which lists others; ParaView opens them as one series.
void write_pvd(std::ostream& out, const std::vector<SeriesEntry>& entries,
               const std::string& remark);

}  // namespace kusabi::pictures
