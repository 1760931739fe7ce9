#pragma once
// How the instructor's report looks: like the book, whose colours and letters it has from docs/site.css.

#include <string_view>

namespace course {

inline constexpr std::string_view report_style = R"(
:root {
  color-scheme: light dark;
  --paper: light-dark(#fdfcfa, #14171d); --ink: light-dark(#20242b, #dcdfe5); --dim: light-dark(#5b6370, #9aa3b2);
  --line: light-dark(#e2dfd8, #2d333e); --shade: light-dark(#f5f3ee, #1b2028);
  --link: light-dark(#1b4f9c, #8db8ff); --accent: light-dark(#c2410c, #ff9c66);
  --good: light-dark(#0a6b4f, #3ddca0); --bad: light-dark(#b3261e, #ff8f85);
  --text: "Source Serif", "Iowan Old Style", Palatino, "Palatino Linotype", Georgia, serif;
  --code: "Source Code", ui-monospace, "SF Mono", "Cascadia Code", "DejaVu Sans Mono", Menlo, Consolas, monospace;
  --plain: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", Arial, sans-serif;
}
*, ::before, ::after { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 400 1.0625rem/1.55 var(--text); overflow-wrap: anywhere; }
main { max-width: 72rem; margin: 0 auto; padding: 2.5rem 2rem 4rem; }
h1, h2, h3 { font-weight: 650; line-height: 1.2; text-wrap: balance; }
h1 { font-size: 2.2rem; letter-spacing: -.02em; margin: 0 0 .3rem; }
h2 { font-size: 1.5rem; letter-spacing: -.01em; margin: 3rem 0 .9rem; }
h3 { font-size: 1.1rem; margin: 1.6rem 0 .4rem; }
details h3 { font-size: 1rem; margin: 1rem 0 .3rem; }
p, ul, dl { margin: 0 0 .8rem; max-width: 44rem; }
ul { padding-left: 1.3rem; }
a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: .18em; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; border-radius: 2px; }
code, pre { font-family: var(--code); font-size: .8125rem; }
pre { margin: 0 0 .8rem; padding: .7rem .9rem; background: var(--shade); border-radius: 6px; line-height: 1.5; white-space: pre-wrap; }
nav { font: .875rem/1.8 var(--plain); }
nav a { margin-right: 1.1rem; white-space: nowrap; }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
.lead, .dim, dt { color: var(--dim); }
.good { color: var(--good); }
.bad { color: var(--bad); }
.facts { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .25rem 1.2rem; margin: 1.4rem 0; }
.facts dt { font: 600 .8125rem/1.95 var(--plain); }
.facts dd { margin: 0; }
.facts ul { margin: 0; }
.ours { border-left: 4px solid var(--bad); padding: .1rem 1rem; margin-top: 2rem; }
.ours h2 { margin-top: 0; color: var(--bad); }
.tag { font: 600 .75rem/1.3 var(--plain); border: 1px solid; border-radius: 4px; padding: .05rem .35rem; white-space: nowrap; }
label { font: .875rem/1.5 var(--plain); cursor: pointer; }
main:has(#only-red:checked) .whole { display: none; }

/* A table that's too wide scrolls in its box; what's written below a student stays where it can be read. */
.table { position: relative; overflow-x: auto; container-type: inline-size; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .9375rem; line-height: 1.4; font-variant-numeric: tabular-nums lining-nums; overflow-wrap: normal; }
th, td { padding: .4rem 1rem .4rem 0; text-align: left; vertical-align: baseline; font-weight: 400; border-bottom: 1px solid var(--line); }
thead th { color: var(--dim); font: 600 .8125rem/1.4 var(--plain); border-bottom-color: var(--dim); white-space: nowrap; }
.students { width: 100%; }
.students tbody:target { background: var(--shade); }
.students tbody th { white-space: nowrap; }
.students .file { width: 100%; min-width: 9rem; color: var(--dim); overflow-wrap: anywhere; }
.students tr:has(+ .more) > * { border-bottom: 0; padding-bottom: .1rem; }
.students .name { min-width: 13rem; }
.more td { padding: 0 0 .4rem; }
.more div { position: sticky; left: 0; max-width: 100cqw; overflow-wrap: anywhere; font-size: .875rem; }
.more p { margin: 0; max-width: none; color: var(--dim); }
.more p.bad { color: var(--bad); }
summary { cursor: pointer; font: .875rem/1.5 var(--plain); padding: .15rem 0; }
summary::marker { color: var(--dim); }
.more details > p, .group details > p { margin: 0 0 .3rem; color: var(--ink); }
.tests { width: 100%; min-width: 44rem; }
.tests td { overflow-wrap: anywhere; }
.tests td:nth-child(1) { width: 42%; }
.tests td:nth-child(2) { width: 9.5rem; white-space: nowrap; }
.tests p { margin: 0; }
.tests tbody th { padding-top: 1.3rem; font-weight: 650; }
.tests th p { font-weight: 400; }
.bar { display: inline-block; width: 4.5rem; height: .6rem; margin-right: .5rem; border: 1px solid var(--dim); border-radius: 2px; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.bar span { display: block; height: 100%; background: var(--good); }

@media (max-width: 40rem) {
  main { padding: 1.5rem 1rem 3rem; }
  h1 { font-size: 1.7rem; }
  .facts { grid-template-columns: minmax(0, 1fr); gap: 0; }
  .facts dd { margin-bottom: .5rem; }
  .students .name { min-width: 8rem; }
  .tests { min-width: 0; }
  .tests thead { display: none; }
  .tests :is(tbody, tr, td, th) { display: block; width: auto !important; }
  .tests :is(th, td) { border: 0; padding-bottom: .1rem; }
  .tests td { padding-top: .1rem; }
  .tests tr { border-bottom: 1px solid var(--line); padding: .4rem 0; }
}
@media print {
  @page { size: A4; margin: 16mm 14mm; }
  :root {
    color-scheme: light;
    --paper: #fff; --ink: #111; --dim: #4b515b; --line: #ccc; --shade: #fff; --link: #111;
  }
  html { font-size: 9.5pt; }
  main { padding: 0; max-width: none; }
  nav, .filter { display: none; }
  .table { overflow: visible; container-type: normal; }
  th, td { padding-right: .6em; }
  .students .name { min-width: 8rem; }
  .more div { position: static; max-width: none; }
  .tests { min-width: 0; }
  pre { border: 1px solid var(--line); }
  tr, .group { break-inside: avoid; }
  tr:has(+ .more), h2, h3 { break-after: avoid; }
}
)";

} // namespace course
