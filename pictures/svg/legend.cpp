// Legend: one list of marks with their condition, sample and text.
#include "pictures/svg/legend.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pictures/svg/friction_use.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/support_drawing.hpp"

namespace kusabi::pictures {
namespace {

using LegendSample = std::function<void(Canvas&, const PixelPoint&)>;

constexpr double half_sample = 13;

LegendSample line_of(const char* group, const char* kind) {
  return [=](Canvas& canvas, const PixelPoint& middle) {
    canvas.begin_group(group);
    canvas.line(kind, middle - PixelPoint(half_sample, 0), middle + PixelPoint(half_sample, 0));
    canvas.end_group();
  };
}

LegendSample area_of(const char* group) {
  return [=](Canvas& canvas, const PixelPoint& middle) {
    canvas.begin_group(group);
    canvas.rectangle("face", middle - PixelPoint(half_sample, 6), PixelPoint(2 * half_sample, 12));
    canvas.end_group();
  };
}

LegendSample arrow_of(const char* kind) {
  return [=](Canvas& canvas, const PixelPoint& middle) {
    canvas.arrow(kind, middle - PixelPoint(half_sample, 0), middle + PixelPoint(half_sample, 0), 9);
  };
}

LegendSample mark_of(const char* kind) {
  return [=](Canvas& canvas, const PixelPoint& middle) { canvas.circle(kind, middle, 4.5); };
}

void cone_sample(Canvas& canvas, const PixelPoint& middle) {
  constexpr double step = 2 * half_sample / use_shades;
  canvas.begin_group("cone");
  for (int shade = 0; shade < use_shades; ++shade) {
    const PixelPoint tip = middle + PixelPoint(step * (shade + 0.5) - half_sample, 7);
    canvas.polygon(fmt::format("cone u{}", shade),
                   {tip, tip + PixelPoint(-4, -14), tip + PixelPoint(4, -14)});
  }
  canvas.end_group();
}

void support_sample(Canvas& canvas, const PixelPoint& middle) {
  canvas.begin_group("support");
  canvas.polygon(
      "held", {middle - PixelPoint(0, 5), middle + PixelPoint(6, 5), middle + PixelPoint(-6, 5)});
  canvas.end_group();
}

void inclined_sample(Canvas& canvas, const PixelPoint& middle) {
  const PixelPoint back(std::sin(0.5), std::cos(0.5));
  canvas.begin_group("support");
  draw_roller(canvas, middle - 6 * back, back, 9);
  canvas.end_group();
}

void spring_sample(Canvas& canvas, const PixelPoint& middle) {
  canvas.begin_group("support");
  draw_spring(canvas, middle - PixelPoint(half_sample, 0), PixelPoint(1, 0), 2 * half_sample);
  canvas.end_group();
}

void obstacle_sample(Canvas& canvas, const PixelPoint& middle) {
  canvas.begin_group("obstacle");
  canvas.line("surface", middle - PixelPoint(half_sample, 3), middle + PixelPoint(half_sample, -3));
  for (double x = -half_sample; x < half_sample; x += 6)
    canvas.line("hatch", middle + PixelPoint(x + 5, -3), middle + PixelPoint(x, 5));
  canvas.end_group();
}

// Samples for structures in space.
void support_sample_in_space(Canvas& canvas, const PixelPoint& middle) {
  canvas.begin_group("support");
  canvas.rectangle("held", middle - PixelPoint(5, 5), PixelPoint(10, 10));
  canvas.end_group();
}

void obstacle_sample_in_space(Canvas& canvas, const PixelPoint& middle) {
  constexpr int points_of_ellipse = 24;
  std::vector<PixelPoint> ellipse;
  for (int i = 0; i < points_of_ellipse; ++i) {
    const double turn = 2 * std::numbers::pi * i / points_of_ellipse;
    ellipse.emplace_back(middle + PixelPoint(12 * std::cos(turn), 5 * std::sin(turn)));
  }
  canvas.begin_group("obstacle");
  canvas.polygon("disc", ellipse);
  canvas.end_group();
}

long count_of(const Scene& scene, ContactState state) {
  return std::ranges::count(scene.candidates, state, &DrawnCandidate::state);
}

long count_of(const Scene& scene, BarState state) {
  return std::ranges::count(scene.bars, state, &DrawnBar::state);
}

bool has(const Scene& scene, DrawnLoad::Kind kind) {
  return std::ranges::count(scene.loads, kind, &DrawnLoad::kind) > 0;
}

/// Meaning of the shades of cones.
constexpr const char* shades_text = "used up to 50, 75, 95, 100\u00A0%";

// "friction cone, μ = 0.65; …", or the range of mu over the candidates in contact.
std::string friction_text(const Scene& scene) {
  double minimum = HUGE_VAL;
  double maximum = 0;
  for (const auto& candidate : scene.candidates) {
    if (candidate.state != ContactState::contact) continue;
    minimum = std::min(minimum, candidate.friction);
    maximum = std::max(maximum, candidate.friction);
  }
  return fmt::format("{}; {}",
                     minimum == maximum
                         ? fmt::format("friction cone, μ = {:.6g}", maximum)
                         : fmt::format("friction cones, μ = {:.6g} to {:.6g}", minimum, maximum),
                     shades_text);
}

std::string largest(const std::string& what, double size, const std::string& unit) {
  return fmt::format("{}, largest {:.4g}\u00A0{}", what, size, unit);
}

// True if forces are drawn, but not those of the supports.
bool lacks_support_reactions(const Scene& scene) {
  const bool forces =
      !scene.loads.empty() || std::ranges::any_of(scene.candidates, [](const auto& candidate) {
        return !candidate.reaction.isZero(0);
      });
  return forces && scene.support_reactions.cols() == 0;
}

void add_supports(std::vector<LegendEntry>& entries, const Scene& scene, bool without_reactions) {
  const std::string more = without_reactions ? " (reaction not drawn)" : "";
  if (!scene.supports.empty())
    entries.push_back(
        {scene.dimension == 2 ? support_sample : support_sample_in_space, "support" + more});
  if (!scene.inclined.empty()) entries.push_back({inclined_sample, "inclined support" + more});
  if (!scene.springs.empty()) entries.push_back({spring_sample, "spring" + more});
  if (!scene.ties.empty()) entries.push_back({line_of("support", "tie"), "tie: a dependent node"});
}

void add_obstacle(std::vector<LegendEntry>& entries, const Scene& scene) {
  if (std::ranges::any_of(scene.candidates, &DrawnCandidate::rigid))
    entries.push_back(
        {scene.dimension == 2 ? obstacle_sample : obstacle_sample_in_space, "obstacle"});
}

void add_structure(std::vector<LegendEntry>& entries, const Scene& scene, const Scales& scales,
                   const UnitNames& units) {
  const bool bodies = !scene.faces.empty();
  const bool moves = scales.displacement > 0;
  const char* const kind = moves ? "rest" : "rest still";
  entries.push_back({bodies ? area_of(kind) : line_of(kind, "bar"),
                     moves ? "the undeformed structure" : "the structure"});
  if (moves) {
    const auto text =
        scene.collapse
            ? fmt::format("{}: velocities × {:g}", scene.motion, scales.displacement)
            : fmt::format("displacements × {:g}, largest {:.4g}\u00A0{}", scales.displacement,
                          scales.largest_displacement, units.length);
    entries.push_back({bodies ? area_of("moved") : line_of("moved", "bar"), text});
  }
  if (const auto count = count_of(scene, BarState::tension); count > 0)
    entries.push_back(
        {line_of("moved", "bar tension"), fmt::format("yields in tension ({})", count)});
  if (const auto count = count_of(scene, BarState::compression); count > 0) {
    entries.push_back(
        {line_of("moved", "bar compression"), fmt::format("yields in compression ({})", count)});
  }
  if (const auto count = count_of(scene, BarState::lost); count > 0)
    entries.push_back({line_of(kind, "bar lost"), fmt::format("lost ({})", count)});
  add_supports(entries, scene, lacks_support_reactions(scene));
}

void add_contact(std::vector<LegendEntry>& entries, const Scene& scene, const Scales& scales,
                 const UnitNames& units) {
  add_obstacle(entries, scene);
  const auto add_count = [&](ContactState state, const char* kind, const char* text) {
    if (const auto count = count_of(scene, state); count > 0)
      entries.push_back({mark_of(kind), fmt::format("{} ({})", text, count)});
  };
  add_count(ContactState::contact, "contact", "in contact");
  add_count(ContactState::separated, "separated", "separated");
  add_count(ContactState::inactive, "idle", "neither a reaction nor a gap");
  const bool solved = std::ranges::any_of(
      scene.candidates, [](const auto& each) { return each.state != ContactState::none; });
  add_count(ContactState::none, "other",
            solved ? "candidate of another block" : "contact candidate");
  if (count_of(scene, ContactState::contact) > 0)
    entries.push_back({cone_sample, friction_text(scene)});
  if (scales.largest_reaction > 0) {
    const bool pairs = !std::ranges::all_of(scene.candidates, &DrawnCandidate::rigid);
    entries.push_back({arrow_of("reaction"),
                       largest(pairs ? "reaction, between bodies on the first of them" : "reaction",
                               scales.largest_reaction, units.force)});
  }
}

}  // namespace

std::vector<LegendEntry> legend(const Scene& scene, const UnitNames& units) {
  const auto scales = scales_of(scene);
  std::vector<LegendEntry> entries;
  add_structure(entries, scene, scales, units);
  add_contact(entries, scene, scales, units);
  if (scales.largest_support_reaction > 0) {
    entries.push_back({arrow_of("holding"), largest("reaction of a support",
                                                    scales.largest_support_reaction, units.force)});
  }
  const auto add_load = [&](DrawnLoad::Kind kind, const char* name, const std::string& text) {
    double size = 0;
    for (const auto& load : scene.loads) {
      if (load.kind == kind) size = std::max(size, load.force.norm());
    }
    if (has(scene, kind)) entries.push_back({arrow_of(name), largest(text, size, units.force)});
  };
  add_load(DrawnLoad::Kind::dead, "dead", scene.load_names.dead);
  add_load(DrawnLoad::Kind::reference, "reference", scene.load_names.reference);
  return entries;
}

std::vector<LegendEntry> common_legend(const std::vector<Scene>& scenes) {
  const auto any = [&](auto&& holds) { return std::ranges::any_of(scenes, holds); };
  const bool bodies = !scenes.front().faces.empty();
  std::vector<LegendEntry> entries;
  entries.push_back(
      {bodies ? area_of("rest") : line_of("rest", "bar"), "the undeformed structure"});
  if (any([](const Scene& its) { return its.displacements.cols() > 0; })) {
    entries.push_back(
        {bodies ? area_of("moved") : line_of("moved", "bar"), "deformed, each by its own factor"});
  }
  if (any([](const Scene& its) { return count_of(its, BarState::tension) > 0; }))
    entries.push_back({line_of("moved", "bar tension"), "yields in tension"});
  if (any([](const Scene& its) { return count_of(its, BarState::compression) > 0; }))
    entries.push_back({line_of("moved", "bar compression"), "yields in compression"});
  if (any([](const Scene& its) { return count_of(its, BarState::lost) > 0; }))
    entries.push_back({line_of("rest", "bar lost"), "lost"});
  // All are of one structure.
  add_supports(entries, scenes.front(), any(lacks_support_reactions));
  add_obstacle(entries, scenes.front());
  if (any([](const Scene& its) { return count_of(its, ContactState::contact) > 0; })) {
    entries.push_back({mark_of("contact"), "in contact"});
    entries.push_back({arrow_of("reaction"), "reaction"});
    entries.push_back({cone_sample, fmt::format("friction cone, {}", shades_text)});
  }
  if (any([](const Scene& its) { return count_of(its, ContactState::separated) > 0; }))
    entries.push_back({mark_of("separated"), "separated"});
  if (any([](const Scene& its) { return count_of(its, ContactState::inactive) > 0; }))
    entries.push_back({mark_of("idle"), "neither a reaction nor a gap"});
  if (any([](const Scene& its) { return !its.support_reactions.isZero(0); }))
    entries.push_back({arrow_of("holding"), "reaction of a support"});
  if (any([](const Scene& its) { return has(its, DrawnLoad::Kind::dead); }))
    entries.push_back({arrow_of("dead"), "dead load"});
  if (any([](const Scene& its) { return has(its, DrawnLoad::Kind::reference); }))
    entries.push_back({arrow_of("reference"), "reference load, times its factor"});
  return entries;
}

double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries,
                   const PixelPoint& corner, double width, int columns) {
  constexpr double row = 24;
  constexpr double next_line = 17;
  constexpr double before = 2 * half_sample + 14;  // a text
  constexpr double letter = 7.1;                   // its mean width, pixels
  const auto longest = static_cast<std::size_t>((width / columns - before) / letter);
  const auto height_of = [&](const LegendEntry& entry) {
    return row + next_line * static_cast<double>(lines_of(entry.text, longest).size() - 1);
  };
  double height = 0;
  for (const auto& entry : entries) height += height_of(entry);
  int column = 0;
  double down = 0, lowest = 0;
  for (const auto& entry : entries) {
    if (down * columns >= height) {
      ++column;
      down = 0;
    }
    PixelPoint place = corner + PixelPoint(width / columns * column, down + row / 2);
    down += height_of(entry);
    lowest = std::max(lowest, down);
    entry.sample(canvas, place + PixelPoint(half_sample + 2, 0));
    for (const auto& line : lines_of(entry.text, longest)) {
      canvas.words("word", place + PixelPoint(before, 4.5), "start", line);
      place.y() += next_line;
    }
  }
  return lowest;
}

}  // namespace kusabi::pictures
