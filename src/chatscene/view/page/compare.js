// Two runs beside each other: what was asked, read and came of them, their programs, their reports.
import { $, ask, element, framed, reportOf } from "./page.js";
import { lines } from "./talk.js";

export async function showCompared(first, second) {
  $("compared").replaceChildren(element("p", { className: "quiet" }, "Reading the two runs …"));
  $("frames").replaceChildren();
  const { groups, difference } = await ask(`compare?first=${encodeURIComponent(first)}&second=${encodeURIComponent(second)}`);
  const head = element("tr", {}, element("td"), ...[first, second].map((name) =>
    element("th", { scope: "col" }, element("a", { href: `#/run/${encodeURIComponent(name)}` }, name))));
  const body = groups.flatMap(({ title, rows }) => [
    element("tr", { className: "group" }, element("th", { colSpan: 3, scope: "rowgroup" }, `What was ${title}`.replace("was came to", "came of it"))),
    ...rows.map(({ name, values: [a, b] }) =>
      element("tr", { className: a === b ? "" : "differs" }, element("th", { scope: "row" }, name, a === b ? null : element("span", { title: "differs" }, " ≠")), ...[a, b].map((value) => element("td", {}, value || "–")))),
  ]);
  const program = difference.length
    ? element("details", { open: difference.length <= 12 }, element("summary", {}, "Lines that only the program of the first (−) or of the second (+) has"), lines(difference))
    : element("p", { className: "quiet" }, "Their programs are the same.");
  $("compared").replaceChildren(element("table", { className: "compared" }, element("thead", {}, head), element("tbody", {}, body)), program);
  $("frames").replaceChildren(...[first, second].map((name) => element("section", {}, element("h2", {}, name), framed(reportOf(name), `Report: ${name}`))));
}
