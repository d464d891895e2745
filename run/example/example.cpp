// `kusabi example`: problem files of parametric families, used for measurements.
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "problems/families/dome.hpp"
#include "problems/families/grid_truss.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/families/space_truss.hpp"
#include "problems/families/tower.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

// Options and stages common to all families.
class Example : public Subcommand {
 public:
  void search(CommandRun& run) final {
    text_ = run.session().from_first_rank([&] {
      try {
        return problems::structure_text(structure());
      } catch (const std::invalid_argument& error) {
        throw WrongInput(fmt::format("kusabi {}: {}", run.name(), error.what()));
      }
    });
  }
  std::vector<Step> results(CommandRun& run) final {
    if (!run.wants("--output")) return {CommandRun::print(text_)};
    return {run.file("--output", [this](std::ostream& out) { out << text_; })};
  }

 protected:
  /// @throws std::invalid_argument if the size is invalid
  [[nodiscard]] virtual problems::Structure structure() const = 0;

  static void describe_output(OptionTable& table) {
    table.output("problem file to write. Default: standard output");
    table.quiet();
  }

 private:
  std::string text_;
};

class SpaceTruss final : public Example {
 public:
  void describe(OptionTable& table) override {
    table.number("--rows", &size_.rows, above(0), "number of rows of nodes along y");
    table.number("--depth", &size_.depth, above(0), "number of planes of nodes along z");
    table.number("--bays", &size_.bays, above(0),
                 "number of bays between the wall and the obstacle");
    describe_output(table);
  }

 private:
  [[nodiscard]] problems::Structure structure() const override {
    return problems::space_truss(size_);
  }

  problems::SpaceTrussSize size_;
};

class PlaneTruss final : public Example {
 public:
  void describe(OptionTable& table) override {
    using problems::Verticals;
    table.number("--rows", &size_.rows, above(0), "number of rows of nodes along y, 1 m apart");
    table.number("--bays", &size_.bays, above(0),
                 "number of bays between the wall and the obstacle");
    table.number("--width", &size_.width, above(0), "width of the lowest row").unit("m");
    table.number("--lean", &size_.lean, at_least(0), "angle of the obstacle to the vertical")
        .unit("degrees");
    table.choice("--brace", size_.verticals,
                 {{"none", Verticals::none}, {"inner", Verticals::inner}, {"all", Verticals::all}},
                 "vertical bars in addition to the diagonals: none, in the inner columns, or also "
                 "along the obstacle");
    table.flag("--paper", paper_,
               "truss of section 7.2 of the paper on wedged configurations, which --rows alone "
               "determines");
    describe_output(table);
  }
  void check() const override {
    const problems::PlaneTrussSize usual;
    if (paper_ && (size_.bays != usual.bays || size_.width != usual.width ||
                   size_.lean != usual.lean || size_.verticals != usual.verticals)) {
      throw WrongInput(
          "--paper: the truss of the paper is given by its number of rows; expected --rows only");
    }
  }

 private:
  [[nodiscard]] problems::Structure structure() const override {
    return paper_ ? problems::paper_plane_truss(size_.rows) : problems::plane_truss(size_);
  }

  problems::PlaneTrussSize size_;
  bool paper_ = false;
};

class Grid final : public Example {
 public:
  void describe(OptionTable& table) override {
    table.number("--bays", &bays_, above(0), "number of bays along each axis").required();
    describe_output(table);
  }

 private:
  [[nodiscard]] problems::Structure structure() const override {
    return problems::grid_truss(bays_);
  }

  int bays_ = 0;
};

class Dome final : public Example {
 public:
  void describe(OptionTable& table) override {
    using problems::DomeKind;
    table.choice("--kind", size_.kind,
                 {{"ring", DomeKind::ring},
                  {"lantern", DomeKind::lantern},
                  {"double-layer", DomeKind::double_layer}},
                 "rings around an apex, rings around an open eye with a lantern, or two layers of "
                 "rings around an open eye");
    table.number("--rings", &size_.rings, between(2, problems::max_rings),
                 "number of rings, of which the outermost one is supported");
    table.number("--sectors", &size_.sectors, between(3, problems::max_sectors),
                 "number of nodes of a ring");
    table.number("--radius", &size_.radius, above(0), "radius of the outermost ring").unit("m");
    table.number("--rise", &size_.rise, above(0), "height of the apex above that ring").unit("m");
    describe_output(table);
  }

 private:
  [[nodiscard]] problems::Structure structure() const override { return problems::dome(size_); }

  problems::DomeSize size_;
};

class Tower final : public Example {
 public:
  void describe(OptionTable& table) override {
    table.number("--storeys", &size_.storeys, between(1, problems::max_storeys),
                 "number of storeys");
    table.number("--height", &size_.height, above(0), "height of a storey").unit("m");
    table.number("--base", &size_.base, above(0), "width at the supports").unit("m");
    table.number("--top", &size_.top, above(0), "width at the top").unit("m");
    describe_output(table);
  }

 private:
  [[nodiscard]] problems::Structure structure() const override { return problems::tower(size_); }

  problems::TowerSize size_;
};

}  // namespace

constexpr Registration example_space_truss_subcommand{
    {.name = "example space-truss",
     .chapter = "Generated problem files",
     .purpose = "space truss between a wall and an obstacle",
     .description = "A space truss from a wall to an inclined obstacle, with rows x depth contact "
                    "candidates.",
     .example = "--rows 8 --depth 5 --output truss.toml"},
    make<SpaceTruss>};

constexpr Registration example_plane_truss_subcommand{
    {.name = "example plane-truss",
     .chapter = "Generated problem files",
     .purpose = "plane truss between a wall and an obstacle",
     .description =
         "A plane truss from a wall to an inclined obstacle, with one contact candidate in each "
         "row.",
     .example = "--rows 12 --output truss.toml"},
    make<PlaneTruss>};

constexpr Registration example_grid_subcommand{
    {.name = "example grid",
     .chapter = "Generated problem files",
     .purpose = "plane grid truss for limit analysis",
     .description = "A plane grid truss with crossed diagonals and loads for limit analysis.",
     .example = "--bays 10 --output grid.toml"},
    make<Grid>};

constexpr Registration example_dome_subcommand{
    {.name = "example dome",
     .chapter = "Generated problem files",
     .purpose = "dome for limit analysis",
     .description = "A dome with a reference load and four uncertain loads for limit analysis.",
     .example = "--kind lantern --rings 7 --output dome.toml"},
    make<Dome>};

constexpr Registration example_tower_subcommand{
    {.name = "example tower",
     .chapter = "Generated problem files",
     .purpose = "braced tower for limit analysis",
     .description =
         "A braced square tower with a reference load and four uncertain loads for limit analysis.",
     .example = "--storeys 26 --output tower.toml"},
    make<Tower>};

}  // namespace kusabi::run
