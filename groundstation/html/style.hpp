// The style of a page: system fonts, tables and pictures that scroll on a narrow screen, whole figures in print.
#pragma once

#include <string_view>

namespace skein::html {

inline constexpr std::string_view kStyle = R"css(
:root { color: #1d1d1f; background: #ffffff; font: 16px/1.5 "DejaVu Sans", Verdana, Arial, sans-serif; }
body { max-width: 1120px; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.6rem; margin: 0.5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2rem 0 0.5rem; border-bottom: 1px solid #bbbbbb; break-after: avoid; }
.good, .bad { padding: 0.6rem 1rem; border-left: 6px solid; font-weight: bold; overflow-wrap: anywhere; }
.good { border-color: #009e73; background: #e6f5f0; }
.bad { border-color: #d55e00; background: #fbece2; }
.notes { padding: 0.6rem 1rem 0.6rem 2rem; border-left: 6px solid #e69f00; background: #fdf5e4; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.875rem; }
th, td { text-align: left; padding: 0.25rem 0.7rem; border-bottom: 1px solid #dddddd; vertical-align: top; }
thead th { border-bottom: 2px solid #888888; white-space: nowrap; }
td { font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.facts th { font-weight: normal; color: #555555; white-space: nowrap; }
pre { background: #f5f5f5; padding: 0.8rem; overflow-x: auto; font: 0.8125rem/1.4 "DejaVu Sans Mono", monospace; }
summary { cursor: pointer; margin: 1rem 0; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { display: block; width: 100%; min-width: 640px; max-width: 960px; height: auto; margin: 0 auto; }
figcaption { font-size: 0.875rem; color: #444444; text-align: center; }
@media print {
  body { max-width: none; padding: 0; }
  pre { white-space: pre-wrap; overflow-wrap: anywhere; border: 1px solid #cccccc; }
  .scroll { overflow: visible; }
  figure svg { min-width: 0; max-width: 17cm; }
  tr { break-inside: avoid; }
  details:not([open]) { display: none; }
}
)css";

}  // namespace skein::html
