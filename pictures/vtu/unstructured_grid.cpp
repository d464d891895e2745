// Writer of VTU and PVD files: XML tags around the arrays.
#include "pictures/vtu/unstructured_grid.hpp"

#include <bit>
#include <cstddef>
#include <ostream>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pictures/vtu/encoding.hpp"
#include "pictures/xml_text.hpp"

namespace kusabi::pictures {
namespace {

/// Array size, in bytes, below which compression is not worthwhile.
constexpr std::size_t worth_packing = std::size_t{1} << 15U;

constexpr const char* byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

template <class Number>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
  return "Int8";
}

// Cells in VTK's format: all point indices in sequence, and the end offset of each cell.
struct CellArrays {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
};

CellArrays arrays_of(const std::vector<Cell>& cells) {
  CellArrays arrays;
  for (const auto& [type, points] : cells) {
    arrays.connectivity.insert(arrays.connectivity.end(), points.begin(), points.end());
    arrays.offsets.push_back(static_cast<std::int64_t>(arrays.connectivity.size()));
    arrays.types.push_back(static_cast<std::uint8_t>(type));
  }
  return arrays;
}

std::size_t bytes_in(const std::vector<Field>& fields) {
  std::size_t bytes = 0;
  for (const auto& field : fields) {
    bytes += std::visit(
        [](const auto& values) {
          return static_cast<std::size_t>(values.size()) * sizeof(*values.data());
        },
        field.values);
  }
  return bytes;
}

class GridWriter {
 public:
  GridWriter(std::ostream& out, bool packed) : out_(out), packed_(packed) {}

  template <class Number>
  void array(const std::string& name, Eigen::Index components, std::span<const Number> numbers,
             const std::string& more = {}) {
    const std::span bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    fmt::print(out_,
               "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">"
               "{}{}</DataArray>\n",
               type_name<Number>(), xml_text(name), components, tuples_,
               packed_ ? packed_array(bytes) : plain_array(bytes), more);
  }

  template <class Matrix>
  void matrix(const std::string& name, const Matrix& values, const std::string& unit = {}) {
    using Number = typename Matrix::Scalar;
    array(name, values.rows(),
          std::span<const Number>(values.data(), static_cast<std::size_t>(values.size())),
          unit.empty() ? std::string()
                       : fmt::format("<InformationKey name=\"UNITS_LABEL\" "
                                     "location=\"vtkDataArray\">{}</InformationKey>",
                                     xml_text(unit)));
  }

  // Numbers of the whole grid: one tuple each, which the reader cannot know otherwise.
  void field_data(const std::vector<Field>& all) {
    if (all.empty()) return;
    tuples_ = " NumberOfTuples=\"1\"";
    fields("FieldData", all);
    tuples_ = "";
  }

  void fields(const char* tag, const std::vector<Field>& all) {
    fmt::print(out_, "<{}>\n", tag);
    for (const auto& field : all) {
      std::visit([&](const auto& values) { matrix(field.name, values, field.unit); }, field.values);
    }
    fmt::print(out_, "</{}>\n", tag);
  }

 private:
  std::ostream& out_;
  bool packed_;
  const char* tuples_ = "";
};

}  // namespace

void write_vtu(std::ostream& out, const UnstructuredGrid& grid) {
  const auto [connectivity, offsets, types] = arrays_of(grid.cells);
  const auto bytes = bytes_in(grid.point_data) + bytes_in(grid.cell_data) +
                     static_cast<std::size_t>(grid.points.size()) * sizeof(double) +
                     (connectivity.size() + offsets.size()) * sizeof(std::int64_t);
  const bool packed = bytes > worth_packing;
  GridWriter writer(out, packed);
  fmt::print(out,
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}<VTKFile type=\"UnstructuredGrid\" "
             "version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\"{}>\n"
             "<UnstructuredGrid>\n",
             xml_comment(grid.remark), byte_order,
             packed ? " compressor=\"vtkZLibDataCompressor\"" : "");
  writer.field_data(grid.field_data);
  fmt::print(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.cols(),
             grid.cells.size());
  out << "<Points>\n";
  writer.matrix("points", grid.points);
  out << "</Points>\n<Cells>\n";
  writer.array<std::int64_t>("connectivity", 1, connectivity);
  writer.array<std::int64_t>("offsets", 1, offsets);
  writer.array<std::uint8_t>("types", 1, types);
  out << "</Cells>\n";
  writer.fields("PointData", grid.point_data);
  writer.fields("CellData", grid.cell_data);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

void write_pvd(std::ostream& out, const std::vector<SeriesEntry>& entries,
               const std::string& remark) {
  fmt::print(out,
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}<VTKFile type=\"Collection\" "
             "version=\"1.0\" byte_order=\"{}\">\n<Collection>\n",
             xml_comment(remark), byte_order);
  for (const auto& [file, time] : entries) {
    fmt::print(out, "<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, xml_text(file));
  }
  out << "</Collection>\n</VTKFile>\n";
}

}  // namespace kusabi::pictures
