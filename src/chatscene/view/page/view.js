// Which page is shown, by the address behind #, and what is worked on.
import { $, about, ask, element, framed, reportOf, tell, trying } from "./page.js";
import { showRuns, titleOf } from "./runs.js";
import { hearTurns, showTalk } from "./talk.js";
import { showCompared } from "./compare.js";

const PAGES = {
  runs: showRuns,
  say: showTalk,
  run: showReport,
  evaluation: showReport,
  coverage: (name) => showReport(name, "coverage.html"),
  compare: showCompared,
};
const ELEMENTS = { runs: "runs-page", say: "say-page", run: "report-page", evaluation: "report-page", coverage: "report-page", compare: "compare-page" };
const TITLES = { runs: "Runs", say: "Say and run", run: "Report", evaluation: "Evaluation", coverage: "Coverage", compare: "Two runs" };

async function showReport(name, file) {
  const title = await titleOf(name);
  $("report-title").textContent = title;
  $("report-alone").href = reportOf(name, file);
  $("report-frame").replaceChildren(framed(reportOf(name, file), `Report: ${title}`));
}

const go = trying(async () => {
  const [kind, ...rest] = location.hash.slice(2).split("/");
  const page = kind in PAGES ? kind : "runs";
  for (const id of Object.values(ELEMENTS)) $(id).hidden = id !== ELEMENTS[page];
  for (const link of document.querySelectorAll("nav a")) {
    if (link.hash === `#/${page}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  document.title = `${TITLES[page]} – chatscene`;
  await PAGES[page](...rest.map(decodeURIComponent));
});

let known = 0, waiting = 0;

/** Fetch what is new in the talk; again soon, while something is worked on. */
export const follow = trying(async () => {
  clearTimeout(waiting);
  const { turns, count, work } = await ask(`talk?since=${known}`);
  const ran = known > 0 && turns.some((turn) => turn.kind === "ran");
  known = count;
  showWork(work);
  hearTurns(turns, work);
  if (ran && !$("runs-page").hidden) await go();
  if (work) waiting = setTimeout(follow, 300);
});

function showWork(work) {
  $("work").hidden = !work;
  if (!work) return;
  const far = work.total ? `: ${work.done} of ${work.total}` : "";
  const left = work.left === null ? "" : `, ${work.left} s left`;
  $("work-words").replaceChildren(element("b", {}, work.line === "run" ? "Running" : "Reading"), ` ${work.what || work.line}${far}${left} `, element("small", {}, `${work.seconds} s`));
  if (work.total) Object.assign($("work-bar"), { max: work.total, value: work.done });
  else $("work-bar").removeAttribute("value");
}

$("where").textContent = about.folder;
$("cancel").addEventListener("click", trying(() => tell("cancel", {})));
window.addEventListener("hashchange", go);
document.addEventListener("visibilitychange", () => { if (!document.hidden) follow(); });
document.addEventListener("said", follow);
await go();
await follow();
