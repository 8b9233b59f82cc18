// The list of runs: sorted by what is clicked, filtered by what is typed, two of them chosen to be compared.
import { $, ask, element, plural, trying } from "./page.js";

const COLUMNS = [
  { name: "Run", key: "text" },
  { name: "Ego", key: "ego" },
  { name: "Adversary", key: "adversary" },
  { name: "Driven", key: "ran", number: true },
  { name: "Collided", key: "collided", number: true },
  { name: "Left the road", key: "off_road", number: true },
  { name: "Avoidable", key: "avoidable", number: true },
  { name: "Kept", key: "kept", number: true },
  { name: "Began", key: "began", number: true },
];
let runs = null, pages = [], leftOut = [], order = { key: "began", down: true };
const chosen = new Set();

export async function load() {
  $("count").textContent = "Reading the runs …";
  const found = await ask("runs");
  runs = found.runs;
  pages = found.pages;
  leftOut = found.left_out;
  for (const run of [...chosen]) if (!runs.some((one) => one.run === run)) chosen.delete(run);
}

export async function titleOf(name) {
  if (!runs) await load();
  return runs.find((one) => one.run === name)?.text ?? pages.find((one) => one.name === name)?.title ?? name;
}

export async function showRuns() {
  await load();
  if (!runs.length && !location.hash) location.hash = "#/say";
  show();
}

const hasAll = (text) => $("find").value.toLowerCase().split(/\s+/).every((word) => text.toLowerCase().includes(word));

const shownRuns = () => {
  const said = (run) => [run.text, run.ego, run.adversary, run.run, run.status].join(" ");
  const found = runs.filter((run) => hasAll(said(run)) && (!$("avoidable").checked || run.avoidable));
  const { key, down } = order;
  return found.sort((a, b) => {
    const [x, y] = [a[key], b[key]];
    if (x === null || y === null) return (x === null) - (y === null); // what is not known comes last
    const less = typeof x === "string" ? x.localeCompare(y) : x - y;
    return (down ? -less : less) || a.run.localeCompare(b.run);
  });
};

function show() {
  const found = shownRuns();
  $("count").textContent = runs.length
    ? `${found.length} of ${plural(runs.length, "run")}`
    : "There are no runs here yet: say a situation, and run it.";
  $("runs").hidden = !runs.length;
  $("runs").tBodies[0].replaceChildren(...found.map(row));
  const about = pages.filter((page) => hasAll(`${page.title} ${page.name} ${page.kind}`));
  $("pages").hidden = !about.length;
  $("pages").querySelector("ul").replaceChildren(...about.map((page) => element("li", {},
    element("a", { href: `#/${page.kind}/${encodeURIComponent(page.name)}` }, page.title), " ", element("small", {}, `${page.name}, ${when(page.began)}`))));
  $("left-out").replaceChildren(...leftOut.map((line) => element("li", {}, line)));
  for (const cell of $("runs").querySelectorAll("th[data-key]")) {
    if (cell.dataset.key === order.key) cell.setAttribute("aria-sort", order.down ? "descending" : "ascending");
    else cell.removeAttribute("aria-sort");
  }
  $("order").value = order.key;
  $("compare").disabled = chosen.size !== 2;
}

function row(run) {
  const pick = element("input", { type: "checkbox", checked: chosen.has(run.run), ariaLabel: `Compare ${run.run}` });
  pick.addEventListener("change", () => {
    if (pick.checked) chosen.add(run.run);
    else chosen.delete(run.run);
    if (chosen.size > 2) chosen.delete([...chosen][0]); // the one that was chosen first
    show();
  });
  const still = run.still ? element("img", { src: `still?run=${encodeURIComponent(run.run)}`, alt: "", loading: "lazy", width: 144, height: 96 }) : element("span", { className: "no-still" });
  const title = run.report
    ? element("a", { href: `#/run/${encodeURIComponent(run.run)}` }, run.text)
    : element("span", {}, run.text);
  const unlike = run.status === "done" ? null : element("span", { className: "chip hit", title: run.reason }, run.status);
  const name = element("th", { scope: "row" }, element("div", { className: "run" }, still, element("div", {}, title, element("small", {}, run.run, " ", unlike))));
  const share = run.ran ? ` of ${run.ran}` : "";
  const struck = Object.entries(run.struck).map(([fault, count]) => `${count} ${fault.replaceAll("-", " ")}`).join(", ");
  return element("tr", {},
    element("td", { className: "pick" }, pick),
    name,
    cell("Ego", run.ego),
    cell("Adversary", run.adversary),
    cell("Driven", run.ran),
    cell("Collided", run.collided === null ? null : `${run.collided}${share}`, struck),
    cell("Left the road", run.off_road === null ? null : `${run.off_road}${share}`),
    cell("Avoidable", run.avoidable),
    cell("Kept", run.kept),
    cell("Began", when(run.began)));
}

const when = (seconds) => new Date(seconds * 1000).toLocaleString([], { dateStyle: "short", timeStyle: "short" });

const cell = (label, value, besides = "") => {
  const number = COLUMNS.find((one) => one.name === label).number;
  const told = value === null || value === "" ? "–" : String(value);
  const made = element("td", { className: number ? "n" : "" }, told, besides && [" ", element("small", {}, besides)]);
  made.dataset.label = label;
  return made;
};

function sortBy(key) {
  const number = COLUMNS.find((one) => one.key === key).number ?? false;
  order = { key, down: order.key === key ? !order.down : number };
  show();
}

$("runs").tHead.rows[0].append(
  element("th", { className: "pick" }, element("span", { className: "unseen" }, "Compare")),
  ...COLUMNS.map(({ name, key, number }) => {
    const head = element("th", { scope: "col", className: number ? "n" : "" });
    head.dataset.key = key;
    head.append(element("button", { type: "button", className: "sort" }, name));
    head.firstChild.addEventListener("click", () => sortBy(key));
    return head;
  }));
$("order").append(...COLUMNS.map(({ name, key }) => element("option", { value: key }, name)));
$("order").addEventListener("change", () => sortBy($("order").value));
$("find").addEventListener("input", show);
$("avoidable").addEventListener("change", show);
$("refresh").addEventListener("click", trying(showRuns));
$("compare").addEventListener("click", () => { location.hash = `#/compare/${[...chosen].map(encodeURIComponent).join("/")}`; });
