// Files first, then their list, so that it names only existing files.
#include "run/pictures/vtu_series.hpp"

#include <ostream>
#include <string_view>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

/// Python for `paraview --script=FILE`; it opens the PVD file of the same name in its folder.
inline constexpr std::string_view paraview_script =
    R"("""Opens the PVD file beside this one:  paraview --script=THIS_FILE

The structure is displaced, the largest displacement being a tenth of its size, and coloured by the
equivalent stress or, without elements, by the state of contact; arrows are reactions. The time is
the number of the answer.
"""
import pathlib

from paraview.simple import *

HERE = pathlib.Path(__file__).resolve()
reader = PVDReader(registrationName=HERE.stem, FileName=str(HERE.with_suffix(".pvd")))
reader.UpdatePipeline()
view = GetActiveViewOrCreate("RenderView")
box = reader.GetDataInformation().GetBounds()
size = max(sum((box[2 * k + 1] - box[2 * k]) ** 2 for k in range(3)) ** 0.5, 1e-300)


def largest(name):
    """The largest length of a vector at the points; 0 if there is none of this name."""
    array = reader.PointData.GetArray(name)
    return max(map(abs, array.GetRange(-1))) if array else 0


shown = reader
for motion in ("displacement", "velocity"):
    if largest(motion) > 0:
        shown = WarpByVector(registrationName="displaced", Input=reader, Vectors=["POINTS", motion],
                             ScaleFactor=0.1 * size / largest(motion))
        Show(reader, view).SetRepresentationType("Outline")
        break
picture = Show(shown, view)
picture.SetRepresentationType("Surface With Edges")
picture.LineWidth = 2
for place, name, data in (("CELLS", "von_mises", reader.CellData), ("CELLS", "utilisation", reader.CellData),
                          ("POINTS", "state", reader.PointData)):
    if data.GetArray(name):
        ColorBy(picture, (place, name))
        picture.SetScalarBarVisibility(view, True)
        bar = GetScalarBar(GetColorTransferFunction(name), view)
        bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"
        bar.TitleFontSize = bar.LabelFontSize = 12
        break
for name, colour in (("contact_reaction", (0.74, 0.3, 0)), ("support_reaction", (0.1, 0.5, 0.39)),
                     ("load", (0.51, 0.31, 0.87))):
    if largest(name) > 0:
        arrows = Glyph(registrationName=name, Input=shown, GlyphType="Arrow",
                       OrientationArray=["POINTS", name], ScaleArray=["POINTS", name],
                       ScaleFactor=0.15 * size / largest(name), GlyphMode="All Points")
        drawn = Show(arrows, view)
        drawn.ColorArrayName = ["POINTS", ""]
        drawn.DiffuseColor = drawn.AmbientColor = colour
if box[5] > box[4]:
    view.ApplyIsometricView()
view.ResetCamera()
Render()
)";

}  // namespace

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
