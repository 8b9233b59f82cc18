// --- words beside the picture --------------------------------------------------------------------------------------

function element(name, text, className) {
  const made = document.createElement(name);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

/** A speed [m/s] as people say it. */
function kmh(speed) {
  return Math.abs(3.6 * speed).toFixed(0) + " km/h";
}

function tell() {
  const seconds = (step * drive.dt).toFixed(1), total = ((drive.shown - 1) * drive.dt).toFixed(1);
  $("clock").textContent = seconds + " s of " + total + " s";
  $("time").value = Math.round(step);
  $("time").setAttribute("aria-valuetext", seconds + " seconds");
  $("play").textContent = playing ? "Pause" : step >= lastStep() ? "Replay" : "Play";
  const gauges = [[called(ego()), kmh(at(ego().speed, step))]];
  const other = met();
  if (other) {
    const left = at(drive.near.time, Math.round(step));
    gauges.push([called(other), kmh(at(other.speed, step))], ["gap", at(drive.near.gap, step).toFixed(1) + " m"]);
    gauges.push(["time to collision", left < 0 ? "none" : left.toFixed(1) + " s"]);
  }
  if (ghost()) gauges.push([content.beside.ego, kmh(at(ghost().actors[0].speed, step))]);
  $("gauges").replaceChildren(...gauges.map(([name, value]) => {
    const span = element("span", name + " ");
    span.append(element("b", value));
    return span;
  }));
}

/** Of an actor that an event names, what it is called. */
function namedIn(name) {
  const actor = drive.actors.find((a) => a.name === name);
  return actor ? called(actor) : name;
}

function eventWords(event) {
  const what = event.kind.replace("-", " ") + (event.other ? (event.kind === "collision" ? " with " : ": ") + namedIn(event.other) : "");
  const how = event.kind === "collision" ? ", " + event.side + ", " + kmh(event.impact) : "";
  return (event.step * drive.dt).toFixed(1) + " s  " + what + how;
}

/** What happened and what could have been done, in order: step, words, kind. */
function moments() {
  const events = drive.events.map((event) => [event.step, eventWords(event), event.kind]);
  const marks = (drive.story ? drive.story.marks : []).map(([when, said]) => [when, (when * drive.dt).toFixed(1) + " s  " + said, "mark"]);
  return [...events, ...marks].sort((a, b) => a[0] - b[0]);
}

/** A strip of the story in sentences: who struck whom, until when it could have been avoided, and what another ego does. */
function tellStory(scene) {
  const said = drive.story ? [...drive.story.said] : [];
  const told = [scene.began, scene.harm && "Of such an impact: " + scene.harm + "."];
  said.splice(1, 0, ...told.filter(Boolean)); // after who struck whom
  if (drive.ghost) said.push("The same scene driven by " + content.beside.ego + ", which " + content.beside.senses + ": it " + drive.ghost.came + ".");
  if (!said.length && !scene.collision && scene.distance != null) said.push("It missed by " + scene.distance.toFixed(1) + " m.");
  $("story").replaceChildren(...said.map((one) => element("p", one)));
}

function introduce(scene) {
  $("scene-name").textContent = scene.label;
  const careful = { true: "; a careful driver avoids it", false: "; a careful driver does not avoid it" }[scene.avoidable] || "";
  $("scene-outcome").textContent = scene.collision ? "collision, " + kmh(scene.impact) + careful : scene.ending;
  $("scene-outcome").className = "chip" + (scene.collision ? " hit" : "");
  $("time").max = drive.shown - 1;
  $("events").replaceChildren(...moments().map(([when, said, kind]) => {
    const button = element("button", said, kind === "collision" ? "hit" : kind === "mark" ? "moment" : "");
    button.type = "button";
    button.addEventListener("click", () => { pause(); seek(when); });
    button.title = "Go there";
    return button;
  }));
  tellStory(scene);
  offerFiles(scene);
  for (const id of ["ghost", "ghost-key"]) $(id).hidden = !drive.ghost;
  if (drive.ghost) $("ghost").textContent = $("ghost-key").lastChild.textContent = "with " + content.beside.ego;
  $("metrics").replaceChildren(...scene.numbers.map(([which, value]) => {
    const entry = document.createElement("div"), [name, note] = content.measures[which];
    entry.append(element("dt", name), element("dd", value), element("dd", note, "note"));
    return entry;
  }));
  for (const row of document.querySelectorAll("tr[data-scene]")) {
    if (row.dataset.scene === scene.id) row.setAttribute("aria-current", "true");
    else row.removeAttribute("aria-current");
  }
}

