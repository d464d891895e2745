// CSS styles of the classes of a picture, for light and dark paper.
#pragma once

#include <string_view>

namespace kusabi::pictures {

/// Content of the style element: plain CSS, so that every SVG reader uses the light style; browsers
/// use the dark one if their user prefers it.
inline constexpr std::string_view style = R"(
text { font-family: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", Helvetica, Arial, sans-serif; fill: #1f2328; }
.title { font-size: 21px; font-weight: 600; }
.line { font-size: 13.5px; fill: #57606a; }
.word { font-size: 13px; }
.name { font-size: 11.5px; fill: #57606a; stroke: #ffffff; stroke-width: 2.5px; stroke-opacity: .8; paint-order: stroke; }
.caption { font-size: 12px; font-weight: 600; }
.note { font-size: 11px; fill: #57606a; }
.paper { fill: #ffffff; }
.card { fill: #f6f8fa; stroke: #d8dee4; stroke-width: 1; }
.rule { stroke: #d8dee4; stroke-width: 1; }
line, polyline, polygon, circle, rect { stroke-linecap: round; stroke-linejoin: round; }
.rest .bar { stroke: #b7c0c9; stroke-width: 1.1; }
.rest .face { fill: #eef1f4; stroke: #c8d0d8; stroke-width: .7; }
.rest .lost { stroke: #cf222e; stroke-width: 1.5; stroke-dasharray: 6 4; }
.still .bar { stroke: #6e7781; stroke-width: 1.3; }
.still .face { fill: #e6ebf0; stroke: #8c959f; }
.moved .bar { stroke: #24292f; stroke-width: 1.7; }
.moved .face { fill: #cfe0f2; fill-opacity: .82; stroke: #54779b; stroke-width: .8; }
.still .f0 { fill: #a9b6c2; } .still .f1 { fill: #bcc8d3; } .still .f2 { fill: #cdd7e0; } .still .f3 { fill: #dce4eb; } .still .f4 { fill: #e9eef3; }
.moved .f0, .moved .f1, .moved .f2, .moved .f3, .moved .f4 { fill-opacity: 1; stroke: #6d8fb3; stroke-width: .5; }
.moved .f0 { fill: #84a7cb; } .moved .f1 { fill: #9bb9d8; } .moved .f2 { fill: #b1cae4; } .moved .f3 { fill: #c6d9ed; } .moved .f4 { fill: #d9e7f5; }
.moved .tension { stroke: #cf222e; stroke-width: 3.4; }
.moved .compression { stroke: #0969da; stroke-width: 3.4; }
.obstacle .surface { stroke: #6e7781; stroke-width: 1.6; }
.obstacle .hatch { stroke: #8c959f; stroke-width: .9; }
.obstacle .disc { fill: #8c959f; fill-opacity: .18; stroke: #8c959f; stroke-width: .8; }
.support .held { fill: #6e7781; stroke: #6e7781; stroke-width: 1; }
.support .rolling { fill: #ffffff; stroke: #6e7781; stroke-width: 1.3; }
.support .ground { stroke: #6e7781; stroke-width: 1.3; }
.support .spring { fill: none; stroke: #6e7781; stroke-width: 1.3; }
.support .tie { stroke: #6e7781; stroke-width: 1.1; stroke-dasharray: 3 4; }
.cone { fill: #e3a008; fill-opacity: .2; stroke: #b87a00; stroke-opacity: .55; stroke-width: .8; }
.u1 { fill-opacity: .34; }
.u2 { fill: #e36209; fill-opacity: .4; stroke: #bc4c00; }
.u3 { fill: #cf222e; fill-opacity: .45; stroke: #a40e26; stroke-opacity: .8; }
.far { opacity: .55; }
.reaction { fill: #bc4c00; stroke: #bc4c00; stroke-width: 2.1; }
.holding { fill: #1a7f64; stroke: #1a7f64; stroke-width: 1.6; }
.dead { fill: #8250df; stroke: #8250df; stroke-width: 1.8; }
.reference { fill: #116329; stroke: #116329; stroke-width: 1.8; }
.axis { fill: #8c959f; stroke: #8c959f; stroke-width: 1.2; }
.contact { fill: #bc4c00; stroke: #ffffff; stroke-width: 1; }
.separated { fill: #ffffff; stroke: #0969da; stroke-width: 1.8; }
.idle { fill: #8c959f; stroke: #ffffff; stroke-width: 1; }
.other { fill: #d0d7de; stroke: #8c959f; stroke-width: .8; }
.small .rest .bar { stroke-width: .6; }
.small .rest .face { stroke-width: .35; }
.small .moved .bar { stroke-width: .95; }
.small .moved .face { stroke-width: .4; }
.small .moved .tension, .small .moved .compression { stroke-width: 2.2; }
.small .reaction { stroke-width: 1.3; }
.small .holding, .small .dead, .small .reference { stroke-width: 1; }
.small .support .spring, .small .support .ground, .small .support .rolling { stroke-width: .8; }
.small .support .tie { stroke-width: .7; }
.small .contact, .small .idle { stroke-width: .5; }
.small .separated { stroke-width: 1.1; }
@media (prefers-color-scheme: dark) {
text { fill: #e6edf3; }
.line, .name, .note { fill: #9ea7b3; }
.name { stroke: #0d1117; }
.paper { fill: #0d1117; }
.card { fill: #151b23; stroke: #30363d; }
.rule { stroke: #30363d; }
.rest .bar { stroke: #4b535d; }
.rest .face { fill: #1b222b; stroke: #3a424c; }
.still .bar { stroke: #9ea7b3; }
.still .face { fill: #222b36; stroke: #6e7681; }
.moved .bar { stroke: #e6edf3; }
.moved .face { fill: #23415f; stroke: #79a6d2; }
.still .f0 { fill: #161c24; } .still .f1 { fill: #1d2530; } .still .f2 { fill: #25303c; } .still .f3 { fill: #2e3a49; } .still .f4 { fill: #384657; }
.moved .f0, .moved .f1, .moved .f2, .moved .f3, .moved .f4 { stroke: #5f86ad; }
.moved .f0 { fill: #17293c; } .moved .f1 { fill: #1e354d; } .moved .f2 { fill: #26425f; } .moved .f3 { fill: #2f5072; } .moved .f4 { fill: #3a6089; }
.rest .lost, .moved .tension { stroke: #ff7b72; }
.moved .compression { stroke: #58a6ff; }
.support .rolling, .separated { fill: #0d1117; }
.obstacle .surface, .support .ground, .support .spring, .support .tie { stroke: #9ea7b3; }
.obstacle .disc { fill: #9ea7b3; }
.cone { fill: #e3b341; stroke: #e3b341; }
.u2 { fill: #f0883e; stroke: #f0883e; }
.u3 { fill: #ff7b72; stroke: #ff7b72; }
.reaction { fill: #ffa657; stroke: #ffa657; }
.holding { fill: #4ac2a0; stroke: #4ac2a0; }
.dead { fill: #bc8cff; stroke: #bc8cff; }
.reference { fill: #56d364; stroke: #56d364; }
.contact { fill: #ffa657; stroke: #0d1117; }
.separated { stroke: #58a6ff; }
.idle { stroke: #0d1117; }
.other { fill: #30363d; stroke: #6e7681; }
}
)";

/// Additional styles of charts.
inline constexpr std::string_view chart_style = R"(
.grid { stroke: #d8dee4; stroke-width: 1; }
.frame { stroke: #6e7781; stroke-width: 1.3; }
.s0 { color: #0969da; } .s1 { color: #bc4c00; } .s2 { color: #1a7f64; } .s3 { color: #8250df; }
.curve { fill: none; stroke: currentColor; stroke-width: 2.4; }
.dashed { stroke-dasharray: 7 5; }
.thick { stroke-width: 5; stroke-linecap: butt; }
.arrow { fill: currentColor; stroke: currentColor; }
.area { fill: currentColor; fill-opacity: .22; }
.edge { stroke: currentColor; stroke-width: 1.6; }
.mark { fill: currentColor; stroke: #ffffff; stroke-width: 1.2; }
@media (prefers-color-scheme: dark) {
.grid { stroke: #30363d; }
.frame { stroke: #9ea7b3; }
.s0 { color: #58a6ff; } .s1 { color: #ffa657; } .s2 { color: #4ac2a0; } .s3 { color: #bc8cff; }
.mark { stroke: #0d1117; }
}
)";

}  // namespace kusabi::pictures
