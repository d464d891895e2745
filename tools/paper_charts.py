"""Figures 5 and 10 of the limit paper: functions from the member `result` of a result file to an SVG
text, for tools/figures.
"""
import html
import math
from typing import NamedTuple

SIZE = 860, 470          # pixels
PLOT = 70, 64, 836, 380  # left, top, right, bottom
STYLE = """
text { font: 13px system-ui, "DejaVu Sans", Helvetica, Arial, sans-serif; fill: #1f2328; }
.small { fill: #57606a; }
.paper { fill: #ffffff; }
.grid { stroke: #d8dee4; }
.frame { stroke: #6e7781; stroke-width: 1.3; fill: none; }
.s0 { stroke: #0969da; } .s1 { stroke: #bc4c00; } .s2 { stroke: #1a7f64; }
.curve { fill: none; stroke-width: 2.4; }
.dashed { stroke-dasharray: 8 5; }
.dotted { stroke-dasharray: 2 5; stroke-linecap: round; }
.dots { fill: none; stroke-width: 4; stroke-linecap: round; stroke-opacity: .55; }
@media (prefers-color-scheme: dark) {
text { fill: #e6edf3; }
.small { fill: #9ea7b3; }
.paper { fill: #0d1117; }
.grid { stroke: #30363d; }
.frame { stroke: #9ea7b3; }
.s0 { stroke: #58a6ff; } .s1 { stroke: #ffa657; } .s2 { stroke: #4ac2a0; }
}
"""


class Curve(NamedTuple):
    name: str
    kind: str  # "", "dashed", "dotted"; "dots": points only
    points: list  # pairs of numbers


class Axis:
    """A range of numbers in steps of 1, 2 or 5 times a power of ten, on a line of pixels."""

    def __init__(self, values, start, end):
        low, high = min(values), max(values)
        wanted = (high - low) / 8
        power = 10 ** math.floor(math.log10(wanted))
        self.step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= wanted)
        self.low, self.high = math.floor(low / self.step) * self.step, math.ceil(high / self.step) * self.step
        self.start, self.end = start, end

    def place(self, value):
        return self.start + (self.end - self.start) * (value - self.low) / (self.high - self.low)

    def numbers(self):
        digits = max(0, -math.floor(math.log10(self.step)))
        for number in range(round((self.high - self.low) / self.step) + 1):
            value = self.low + number * self.step
            yield self.place(value), f"{value:.{digits}f}"


def words(x, y, text, anchor="start", kind=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{kind and f" class={chr(34)}{kind}{chr(34)}"}>{html.escape(text)}</text>'


def drawn(curve, number, across, up):
    places = [(across.place(x), up.place(y)) for x, y in curve.points]
    if curve.kind == "dots":
        return f'<path class="dots s{number}" d="{"".join(f"M{x:.1f} {y:.1f}h0" for x, y in places)}"/>'
    line = " ".join(f"{x:.2f},{y:.2f}" for x, y in places)
    return f'<polyline class="curve s{number} {curve.kind}" points="{line}"/>'


def chart(title, x_name, y_name, curves, letters=()):
    """An SVG image. Its title is its accessible name.

    letters: points named in the paper, each with its position and the offset of its name in pixels.
    """
    left, top, right, bottom = PLOT
    across = Axis([x for each in curves for x, _ in each.points], left, right)
    up = Axis([y for each in curves for _, y in each.points], bottom, top)
    width, height = SIZE
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img">',
             f"<title>{html.escape(title)}</title>", f"<style>{STYLE}</style>",
             f'<rect class="paper" width="{width}" height="{height}"/>', words(left - 46, 26, title)]
    for x, text in across.numbers():
        lines += [f'<line class="grid" x1="{x:.2f}" y1="{top}" x2="{x:.2f}" y2="{bottom}"/>', words(x, bottom + 19, text, "middle", "small")]
    for y, text in up.numbers():
        lines += [f'<line class="grid" x1="{left}" y1="{y:.2f}" x2="{right}" y2="{y:.2f}"/>', words(left - 8, y + 4.5, text, "end", "small")]
    lines += [f'<path class="frame" d="M{left} {top}V{bottom}H{right}"/>', words((left + right) / 2, bottom + 40, x_name, "middle"),
              words(left - 46, top - 12, y_name)]
    for number, curve in enumerate(curves):
        x, y = left - 46 + 270 * number, height - 22
        sample = f'd="M{x} {y - 4}h30"' if curve.kind != "dots" else f'd="M{x + 15} {y - 4}h0"'
        kind = "dots" if curve.kind == "dots" else f"curve {curve.kind}"
        lines += [drawn(curve, number, across, up), f'<path class="{kind} s{number}" {sample}/>', words(x + 38, y, curve.name)]
    for name, (x, y), (right_by, down_by) in letters:
        lines.append(words(across.place(x) + right_by, up.place(y) + down_by, name, "middle"))
    return "\n".join(lines) + "\n</svg>\n"


def corners(pieces, scale=1.0, end=1.0):
    """A curve of a result file as points, up to `end`."""
    points = [(scale * each["from"], each["factor_from"]) for each in pieces] + [(scale * pieces[-1]["to"], pieces[-1]["factor_to"])]
    kept = [each for each in points if each[0] <= end]
    if len(kept) < len(points):
        (x, y), (next_x, next_y) = kept[-1], points[len(kept)]
        kept.append((end, y + (next_y - y) * (end - x) / (next_x - x)))
    return kept


def figure_5(result):
    solid, dashed = corners(result["curve"]), corners(result["load_curve"], 0.5)
    worst = corners(result["worst_curve"])
    letters = [("(A)", solid[0], (18, -8)), ("(B)", solid[1], (6, -10)), ("(C)", solid[-1], (-26, 2)),
               ("(D)", dashed[-1], (-12, -12)), ("(E)", worst[1], (-10, 22))]
    return chart("L Figure 5: limit load factor of the 3 × 3 truss as its uncertain loads grow", "β", "λ",
                 [Curve("λ*(f_D + β T ζ₁)", "", solid), Curve("λ*(f_D + 2 β T ζ₂)", "dashed", dashed),
                  Curve("λ_min(β α₁), the worst case", "dotted", worst)], letters)


def figure_10(result):
    factors = result["samples"]["factors"]
    return chart("L Figure 10: limit load factors of the 4 × 4 truss under random loads, α = 40 kN", "number of the load", "λ",
                 [Curve("random loads", "dots", list(enumerate(factors, 1))),
                  Curve("nominal load", "", [(1, result["nominal"]), (len(factors), result["nominal"])]),
                  Curve("λ_min(α), the worst case", "dashed",
                        [(1, result["maximum"]["upper"]["value"]), (len(factors), result["maximum"]["upper"]["value"])])])
