// The conversation: what is said goes to the server as a line of `chatscene chat`; what came of it is a turn.
import { $, about, button, element, framed, plural, reportOf, tell, trying } from "./page.js";

const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
let said = false, undoable = false, ranBefore = null;

/** Say a line; buttons say lines, too. */
const say = trying(async (line) => {
  await tell("say", { line });
  document.dispatchEvent(new Event("said"));
  return true;
});

/** Lines of a program that went (-) and came (+). */
export const lines = (difference) => element("pre", { className: "code difference", tabIndex: 0 },
  element("code", {}, difference.map((line) => element(line[0] === "+" ? "ins" : "del", {}, line))));

/** A text with its words marked by the facts that they gave, as the report has it. */
function account(parts) {
  if (!parts.length) return null;
  const marked = parts.map((part) => {
    const fact = part.fact.replaceAll("_", " ");
    const words = part.fact ? element("ruby", { className: `fact c${part.colour}`, title: fact }, part.text, element("rt", {}, fact))
      : part.unread ? element("ruby", { className: "unread", title: "not read" }, element("s", {}, part.text), element("rt", {}, "not read"))
      : part.besides ? element("span", { className: "besides", title: part.besides }, part.text) : null;
    return [part.before, words];
  });
  return element("p", { className: "account" }, marked.flat());
}

const notes = (texts) => texts.length ? element("ul", { className: "notes" }, texts.map((text) => element("li", {}, text))) : null;

const program = (source) => element("details", {}, element("summary", {}, "The program"), element("pre", { className: "code", tabIndex: 0 }, source));

/** Readings as buttons that take them, and facts that settle which is meant. */
function readings(found, heading) {
  if (!found.length) return null;
  return element("div", { className: "ask" }, element("h3", {}, heading), found.map((one) => element("div", { className: "reading-row" },
    button(one.text, () => say(`reading ${one.reading}`), { className: "reading-choice" }),
    element("span", { className: "chip" }, `${Math.round(100 * one.probability)} %`),
    one.settled_by ? button(`state ${one.settled_by}`, () => say(`set ${one.settled_by}`)) : null)));
}

function change({ fact, before, after, named }) {
  return element("li", {}, element("b", {}, fact.replaceAll("_", " ")), " ", before === "not said" ? before : element("del", {}, before), " → ", after === "not said" ? after : element("ins", {}, after), named ? null : element("small", {}, " follows"));
}

function edited(turn) {
  return [
    element("p", { className: "sentence" }, turn.sentence.flatMap(({ how, text }) =>
      [how === "same" ? text : element(how === "new" ? "ins" : "del", {}, text), " "])),
    element("ul", { className: "changes" }, turn.changes.map(change)),
    notes(turn.notes),
    turn.difference.length
      ? element("details", { open: turn.difference.length <= 10 }, element("summary", {}, `What changes in the program: ${plural(turn.difference.length, "line")}`), lines(turn.difference))
      : element("p", { className: "quiet" }, "The program is as before."),
    program(turn.program),
  ];
}

const KINDS = {
  shown: (turn) => [
    element("p", { className: "sentence" }, turn.told),
    account(turn.parts),
    element("p", { className: "slots" }, turn.facts.map(([name, value]) => element("span", { className: "chip slot" }, element("i", {}, name), ` ${value}`))),
    notes(turn.notes),
    readings(turn.readings, "It may also say"),
    element("details", {}, element("summary", {}, "Snippets that serve it", turn.confidence === null ? null : `, confidence ${Math.round(100 * turn.confidence)} %`),
      element("dl", { className: "snippets" }, turn.snippets.flatMap(([component, name, does]) => [element("dt", {}, component), element("dd", {}, element("code", {}, name), does ? ` ${does}` : "")]))),
    program(turn.program),
  ],
  edited,
  undone: edited,
  refused: (turn) => [
    element("p", { className: "no" }, turn.message),
    account(turn.parts),
    turn.understood ? element("p", {}, element("b", {}, "Understood: "), turn.understood) : null,
    readings(turn.readings, "Is one of these meant?"),
    turn.suggestion ? element("p", {}, "This one works: ", button(turn.suggestion, () => say(`new ${turn.suggestion}`), { className: "reading-choice" })) : null,
  ],
  failed: (turn) => [element("p", { className: "no" }, turn.message)],
  cancelled: (turn) => [element("p", {}, "Cancelled. The situation is as it was."), resume(turn)],
  crashed: (turn) => [element("p", { className: "no" }, `${turn.message}. The situation is as it was.`), resume(turn)],
  ran: (turn) => {
    const before = ranBefore;
    ranBefore = turn.run;
    return [
      turn.summary.map((line) => element("p", {}, line)),
      framed(`${reportOf(turn.run)}#replay`, `Replay: ${turn.run}`),
      element("p", { className: "links" },
        element("a", { href: `#/run/${encodeURIComponent(turn.run)}` }, "The whole report"),
        element("a", { href: reportOf(turn.run), target: "_blank", rel: "noreferrer" }, "In a window of its own"),
        before ? element("a", { href: `#/compare/${encodeURIComponent(before)}/${encodeURIComponent(turn.run)}` }, `Beside ${before}`) : null),
    ];
  },
};
const HEADINGS = {
  shown: "Understood", edited: "Changed", undone: "Taken back", refused: "Refused", failed: "Refused",
  cancelled: "Cancelled", crashed: "Broke off", ran: "Driven",
};

const resume = (turn) => turn.resume ? element("p", {}, "What was finished is kept; go on with: ", element("code", {}, turn.resume)) : null;

function shown(turn) {
  return element("li", { className: `turn ${turn.kind}` },
    element("p", { className: "line" }, element("span", { className: "unseen" }, "You: "), turn.line),
    element("article", { className: "told" }, element("h2", {}, HEADINGS[turn.kind], turn.edit ? `: ${turn.edit}` : ""), KINDS[turn.kind](turn)));
}

/** Show new turns; what can be said next depends on them and on whether something is worked on. */
export function hearTurns(turns, work) {
  for (const turn of turns) {
    if (turn.edits) [said, undoable] = [true, turn.edits.length > 0];
    $("turns").append(shown(turn));
  }
  if (turns.length) $("turns").lastChild.scrollIntoView({ block: "start", behavior: calm ? "auto" : "smooth" });
  $("prompt").textContent = said ? "What is to be another" : "A situation";
  $("line").placeholder = said ? "make it a truck, from the left, at night" : "a pedestrian crosses the road from the right";
  $("say").textContent = said ? "Change it" : "Say it";
  $("say").classList.toggle("primary", !said);
  $("another").hidden = $("undo").hidden = $("run").hidden = !said;
  for (const id of ["say", "another", "state"]) $(id).disabled = Boolean(work);
  $("undo").disabled = Boolean(work) || !undoable;
  $("run").disabled = Boolean(work);
  for (const one of $("turns").querySelectorAll("button")) one.disabled = Boolean(work);
}

export function showTalk() {
  $("turns").lastChild?.scrollIntoView({ block: "start" });
  $("line").focus({ preventScroll: true });
}

async function send(before) {
  const line = $("line").value.trim();
  if (line && await say(before + line)) $("line").value = "";
  $("line").focus({ preventScroll: true });
}

$("composer").addEventListener("submit", (event) => { event.preventDefault(); send(""); });
$("another").addEventListener("click", () => send("new "));
$("undo").addEventListener("click", () => say("undo"));
$("run").addEventListener("click", () => say("run"));
$("run").textContent = `Run ${plural(about.scenes, "scene")}`;
$("line").addEventListener("keydown", (event) => {
  if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
  event.preventDefault();
  if (!$("say").disabled) send("");
});
$("fact").append(...Object.keys(about.facts).map((name) => element("option", { value: name }, name.replaceAll("_", " "))));
const values = () => $("value").replaceChildren(...about.facts[$("fact").value].map((value) => element("option", { value }, value)));
$("fact").addEventListener("change", values);
values();
$("state").addEventListener("click", () => say(`set ${$("fact").value}=${$("value").value}`));
