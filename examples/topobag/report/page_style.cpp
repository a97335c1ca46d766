// SPDX-License-Identifier: MIT
#include "html_page.hpp"

namespace program {

// The colors are those of Okabe and Ito, which color-blind readers can tell apart, darker or
// lighter with the background; beside them, marks differ in shape and lines in their dashes.
const char* const page_style = R"css(
:root {
  --page: #ffffff; --card: #ffffff; --text: #1b2430; --quiet: #566372; --rule: #d5dce4;
  --blue: #0072b2; --sky: #4aa3df; --green: #00805d; --amber: #c98500; --red: #d55e00;
  --pink: #b65a91; --gray: #aab4bf; --panel: #f5f7fa;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #12171d; --card: #1a2129; --text: #e6ebf0; --quiet: #9fadbb; --rule: #34404c;
    --blue: #56b4e9; --sky: #8fd0f5; --green: #2fc39a; --amber: #f0b429; --red: #ff7f50;
    --pink: #e39ac6; --gray: #5d6a77; --panel: #222b35;
  }
}
* { box-sizing: border-box }
body { margin: 0 auto; max-width: 1240px; padding: 24px; background: var(--page);
  color: var(--text); font: 15px/1.5 system-ui, sans-serif }
h1 { font-size: 24px; margin: 0 0 12px }
h2 { font-size: 16px; margin: 0 0 8px }
a { color: var(--blue) }
dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(250px, 1fr)); gap: 8px 24px;
  margin: 0 0 12px }
.long { grid-column: span 2 }
dt { color: var(--quiet); font-size: 13px }
dd { margin: 0; overflow-wrap: anywhere }
.note { border-left: 4px solid var(--amber); margin: 8px 0; padding: 2px 12px }
main { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 460px), 1fr));
  gap: 20px; margin-top: 20px }
figure { margin: 0; padding: 16px; background: var(--card); border: 1px solid var(--rule);
  border-radius: 8px; min-width: 0 }
figure.wide { grid-column: 1 / -1 }
figcaption { color: var(--quiet); font-size: 13.5px; margin-top: 8px }
details { margin-top: 8px; font-size: 13px }
summary { cursor: pointer; color: var(--quiet) }
details div { max-height: 300px; overflow: auto }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: 1px 12px 1px 0; text-align: right; white-space: nowrap }
th { position: sticky; top: 0; background: var(--card) }
.table { overflow-x: auto; font-size: 13.5px }
.table .name { text-align: left }
.download { font-size: 13px }
svg { display: block; width: 100%; height: auto }
.plot text { font: 12px system-ui, sans-serif; fill: var(--text) }
.plot .label { fill: var(--quiet) }
.grid { stroke: var(--rule); stroke-width: 1 }
.axis { stroke: var(--quiet); stroke-width: 1 }
.line { fill: none; stroke: var(--ink); stroke-width: 2; stroke-linejoin: round }
.line.second { stroke-dasharray: 7 4 }
.line.third { stroke-dasharray: 2 3 }
.line.other { stroke-width: 1; opacity: 0.5 }
.line.other:hover { stroke-width: 3; opacity: 1 }
.line.path { stroke-width: 1.5 }
.line.loop { stroke-width: 1.2; stroke-opacity: 0.75 }
.bar { fill: var(--ink); stroke: var(--card); stroke-width: 0.7 }
.bar.over { fill-opacity: 0.55; stroke: var(--ink) }
.dot { fill: var(--ink); stroke: var(--card); stroke-width: 0.8 }
.ring { fill: var(--card); stroke: var(--ink); stroke-width: 1.8 }
.cross { fill: none; stroke: var(--ink); stroke-width: 2.4 }
.first, .true, .correct { --ink: var(--blue) }
.second, .imprecise { --ink: var(--amber) }
.third { --ink: var(--green) }
.other { --ink: var(--gray) }
.false { --ink: var(--red) }
.wrong { --ink: var(--red) }
.missed { --ink: var(--pink) }
.nothing { --ink: var(--gray) }
.map { --ink: var(--gray) }
.query { --ink: var(--green) }
canvas { display: block; width: 100%; height: auto; cursor: crosshair }
.readout { min-height: 3em; margin: 8px 0 0; font-size: 13.5px; font-variant-numeric: tabular-nums }
.drawing { overflow-x: auto }
@media (max-width: 640px) {
  .long { grid-column: auto }
}
@media print {
  body { padding: 0; max-width: none; font-size: 11px }
  main { display: block }
  figure { break-inside: avoid; border: 0; padding: 0 0 16px }
  figure:not(.wide) { max-width: 560px }
  details, .download, .readout { display: none }
}
)css";

}  // namespace program
