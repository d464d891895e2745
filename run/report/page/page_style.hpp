// Style of the page: light and dark screens, phones, paper. Pictures have a style of their own
// (pictures/svg/style.hpp).
#pragma once

#include <string_view>

namespace kusabi::run {

inline constexpr std::string_view page_style = R"(
:root { --ink: #1f2328; --faint: #57606a; --paper: #ffffff; --card: #f6f8fa; --rule: #d8dee4; --mark: #0969da;
--body: 205,222,240; --edge: #6d8fb3; --bar: #24292f; --tension: #cf222e; --compression: #0969da; --held: #6e7781; --reaction: #bc4c00; --holding: #1a7f64; --dead: #8250df; --reference: #116329; --use0: #f0d58a; --use1: #e3a008; --use2: #e36209; --use3: #cf222e; }
@media (prefers-color-scheme: dark) {
:root { --ink: #e6edf3; --faint: #9ea7b3; --paper: #0d1117; --card: #151b23; --rule: #30363d; --mark: #58a6ff;
--body: 66,106,150; --edge: #83a9d0; --bar: #e6edf3; --tension: #ff7b72; --compression: #58a6ff; --held: #9ea7b3; --reaction: #ffa657; --holding: #4ac2a0; --dead: #bc8cff; --reference: #56d364; --use0: #8a743a; --use1: #e3b341; --use2: #f0883e; --use3: #ff7b72; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 76rem; background: var(--paper); color: var(--ink); font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.25rem; border-bottom: 1px solid var(--rule); padding-bottom: .2rem; margin-top: 2rem; }
h3 { font-size: 1rem; margin: .3rem 0; }
#verdict { font-size: 1.25rem; font-weight: 600; border-left: .3rem solid var(--mark); padding-left: .8rem; margin: .8rem 0; }
#warnings { border-left: .3rem solid var(--tension); padding: .2rem .8rem .2rem 2rem; }
#reservations, .remark { color: var(--faint); }
figure { margin: 0; }
figure canvas { width: 100%; height: min(70vw, 34rem); display: block; border: 1px solid var(--rule); border-radius: .4rem; touch-action: pan-y; cursor: grab; }
figure.turns svg.picture { display: none; }
figure .remark { margin: .2rem 0; font-size: .9rem; }
figure input[type="range"] { vertical-align: middle; padding: 0; }
h4 { font-size: 1rem; margin: .3rem 0; }
.ungrouped .group h3, .ungrouped .group .remark, .on-paper { display: none; }
svg.picture { display: block; max-width: 100%; height: auto; }
#leading figure svg.picture { width: 100%; }
.scroll { overflow-x: auto; margin: .6rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
caption { width: max-content; max-width: calc(100vw - 2rem); text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: left; vertical-align: top; padding: .2rem .8rem .2rem 0; border-bottom: 1px solid var(--rule); }
th { font-weight: 400; color: var(--faint); overflow-wrap: normal; }
thead th { font-weight: 600; }
thead + tbody td { overflow-wrap: break-word; }
data { white-space: nowrap; }
.gallery { list-style: none; padding: 0; display: grid; gap: .8rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr)); }
li.answer { background: var(--card); border: 1px solid var(--rule); border-radius: .4rem; padding: .6rem; content-visibility: auto; contain-intrinsic-size: auto 17rem auto 28rem; }
li.answer svg { margin: 0 auto; }
#answers > .scroll { content-visibility: auto; contain-intrinsic-size: auto 60rem; }
pre { white-space: pre-wrap; font-size: .85rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem .7rem; margin: .5rem 0; font-size: .9rem; }
dt { color: var(--faint); }
dd { margin: 0; }
#controls { display: flex; flex-wrap: wrap; gap: .4rem 1.2rem; }
#controls p { margin: 0; }
[hidden], #controls[hidden] { display: none; }
#choice { margin: 0 0 .6rem; }
input, select, button { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--faint); border-radius: .3rem; padding: .25rem .5rem; max-width: 100%; }
:focus-visible { outline: 3px solid var(--mark); outline-offset: 2px; }
summary { cursor: pointer; }
@media screen and (max-width: 30rem) {
svg.picture .large .name { font-size: 18px; }
svg.picture .chart text { font-size: 18px; }
}
@media screen and (min-width: 60rem) {
.beside { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); column-gap: 2rem; align-items: start; }
.beside > :only-child, #choice { grid-column: 1 / 3; }
.beside h2 { margin-top: 0; }
#problem { display: grid; grid-template-columns: minmax(0, 2fr) minmax(0, 3fr); grid-template-rows: auto auto auto 1fr; column-gap: 2rem; align-items: start; }
#problem h2 { grid-column: 1 / 3; }
#problem #structure { grid-row: 2 / 5; }
#problem > :not(h2):not(#structure) { grid-column: 2; }
}
@media print {
#controls, #choice { display: none; }
body { max-width: none; padding: 0; font-size: .8rem; }
figure.turns svg.picture { display: block; }
figure canvas, figure .remark, figure label, .gallery li.answer:not(.large), tr.late { display: none; }
tr.on-paper { display: table-row; }
li.answer { break-inside: avoid; content-visibility: visible; }
.gallery { display: block; }
.gallery li.answer.large { display: inline-block; width: 48%; vertical-align: top; }
details:not([open]) { display: none; }
.scroll { overflow: visible; }
#answers > .scroll { content-visibility: visible; }
th, td { padding: .1rem .4rem .1rem 0; }
li.answer table { font-size: .65rem; }
h2, h3, caption { break-after: avoid; }
}
)";

}  // namespace kusabi::run
