"use strict";
(() => {
const $ = (id) => document.getElementById(id);
const content = JSON.parse($("content").textContent);
const scenes = content.scenes;

window.addEventListener("error", (event) => {
  $("trouble").hidden = false;
  $("trouble").textContent = "The replay stopped: " + event.message;
});

// --- unpacking: numbers are kept as differences of whole centimetres, milliradians and centimetres a second ------

function unpack(differences, scale, count) {
  const values = new Float64Array(count);
  let sum = 0;
  for (let i = 0; i < count; i++) {
    if (i < differences.length) sum += differences[i];
    values[i] = sum / scale;
  }
  return values;
}

function unpackLine(differences) {
  const points = [];
  let x = 0, y = 0;
  for (let i = 0; i < differences.length; i += 2) {
    x += differences[i];
    y += differences[i + 1];
    points.push([x / 100, y / 100]);
  }
  return points;
}

/** An area as one path: its outer ring, then its holes. */
function unpackArea(rings) {
  const area = new Path2D();
  for (const ring of rings) {
    unpackLine(ring).forEach(([x, y], i) => (i ? area.lineTo(x, y) : area.moveTo(x, y)));
    area.closePath();
  }
  return area;
}

function unpackDrive(drive) {
  const count = drive.steps;
  const actors = drive.actors.map((a) => ({
    ...a,
    x: unpack(a.x, 100, count), y: unpack(a.y, 100, count),
    heading: unpack(a.heading, 1000, count), speed: unpack(a.speed, 100, count),
  }));
  const signals = drive.signals.map((s) => ({ ...s, states: s.states.map(([c, n]) => c.repeat(n)).join("") }));
  return { ...drive, actors, signals };
}

const map = {
  sidewalks: content.map.sidewalks.map(unpackArea),
  shoulders: content.map.shoulders.map(unpackArea),
  roads: content.map.roads.map(unpackArea),
  junctions: content.map.junctions.map(unpackArea),
  crosswalks: content.map.crosswalks.map(unpackArea),
  stops: content.map.stop_lines.map(unpackLine),
  lines: content.map.lane_boundaries.map((line) => ({ kind: line.kind, points: unpackLine(line.points) })),
  routes: Object.fromEntries(Object.entries(content.map.routes).map(([name, line]) => [name, unpackLine(line)])),
};

// --- state ---------------------------------------------------------------------------------------------------------

const view = $("view"), speeds = $("speeds");
const canvas = view.getContext("2d"), chart = speeds.getContext("2d");
const camera = { x: 0, y: 0, zoom: 8, closer: 1, follow: true };
let shown = 0, drive = null, step = 0, playing = false, timer = 0, last = 0;
let colours = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["ego", "adversary", "background", "occluder", "ground", "sidewalk", "shoulder", "road", "paint", "centre",
    "stop", "route", "label", "green", "yellow", "red", "card", "ink", "soft", "line", "hit"]) {
    colours[name] = style.getPropertyValue("--" + name).trim();
  }
}

/** A quantity of an actor at a step that may lie between two. */
function at(values, when) {
  const i = Math.min(Math.floor(when), values.length - 1), j = Math.min(i + 1, values.length - 1);
  return values[i] + (values[j] - values[i]) * (when - i);
}

const ego = () => drive.actors[0];
const adversaries = () => drive.actors.filter((a) => a.role === "adversary");
const crash = () => drive.events.find((event) => event.kind === "collision");
const LEAD = 4; // [s] before a contact that a replay starts at

/** Who the ego meets: whom it collides with, else the adversary. */
const met = () => drive.actors.find((a) => a.name === crash()?.other) || adversaries()[0];

/** What an actor is called: by what it is, and the ego by who drives. */
const called = (actor) => (actor.role === "ego" ? "ego: " + content.ego : content.called[actor.kind]);

// --- drawing -------------------------------------------------------------------------------------------------------

/** Match a canvas to its size on the screen; answers its size in CSS pixels. */
function fit(element, context) {
  const width = element.clientWidth, height = element.clientHeight, ratio = window.devicePixelRatio || 1;
  const w = Math.round(width * ratio), h = Math.round(height * ratio);
  if (element.width !== w || element.height !== h) { element.width = w; element.height = h; }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return [width, height];
}

function path(points, closed) {
  canvas.beginPath();
  points.forEach(([x, y], i) => (i ? canvas.lineTo(x, y) : canvas.moveTo(x, y)));
  if (closed) canvas.closePath();
}

function fillAll(areas, colour) {
  canvas.fillStyle = canvas.strokeStyle = colour;
  canvas.lineWidth = 0.14; // closes the hairlines between neighbours
  for (const area of areas) { canvas.fill(area, "evenodd"); canvas.stroke(area); }
}

function drawMap() {
  fillAll(map.sidewalks, colours.sidewalk);
  fillAll(map.shoulders, colours.shoulder);
  fillAll(map.roads, colours.road);
  fillAll(map.junctions, colours.road);
  canvas.fillStyle = colours.paint;
  for (const stripe of map.crosswalks) canvas.fill(stripe);
  canvas.lineCap = "butt";
  for (const line of map.lines) {
    canvas.strokeStyle = line.kind === "centre" ? colours.centre : colours.paint;
    canvas.lineWidth = Math.max(0.14, 1 / camera.zoom);
    canvas.setLineDash(line.kind === "dashed" ? [3, 4.5] : []);
    path(line.points); canvas.stroke();
  }
  canvas.setLineDash([]);
  canvas.strokeStyle = colours.stop;
  canvas.lineWidth = Math.max(0.35, 1.5 / camera.zoom);
  for (const line of map.stops) { path(line); canvas.stroke(); }
}

function drawRoute() {
  const route = map.routes[scenes[shown].route];
  if (!route) return;
  canvas.strokeStyle = colours.route;
  canvas.globalAlpha = 0.4;
  canvas.lineWidth = Math.max(0.18, 1.2 / camera.zoom);
  canvas.setLineDash([1, 2]);
  path(route); canvas.stroke();
  canvas.setLineDash([]);
  canvas.globalAlpha = 1;
}

function drawSignals() {
  const names = { r: "red", y: "yellow", g: "green" };
  for (const signal of drive.signals) {
    const [x0, y0, x1, y1] = signal.line;
    canvas.strokeStyle = canvas.fillStyle = colours[names[signal.states[Math.floor(step)]]] || colours.soft;
    canvas.lineWidth = Math.max(0.6, 3 / camera.zoom);
    path([[x0, y0], [x1, y1]]); canvas.stroke();
    if (signal.role !== "ego") continue;
    canvas.beginPath(); canvas.arc(x0, y0, Math.max(0.7, 5 / camera.zoom), 0, 7); canvas.fill();
  }
}

function drawTrail(actor) {
  const end = Math.floor(step);
  canvas.strokeStyle = colours[actor.role];
  canvas.globalAlpha = 0.5;
  canvas.lineWidth = Math.max(0.22, 1.6 / camera.zoom);
  canvas.lineJoin = "round";
  canvas.beginPath();
  canvas.moveTo(actor.x[0], actor.y[0]);
  for (let i = 1; i <= end; i++) canvas.lineTo(actor.x[i], actor.y[i]);
  canvas.lineTo(at(actor.x, step), at(actor.y, step));
  canvas.stroke();
  canvas.globalAlpha = 1;
}

const SHAPES = { walks: drawWalker, rides: drawTwoWheeler, drives: drawVehicle, lies: drawProp };

/** Draws at the origin, heading along +x; metres. */
function drawActor(actor) {
  canvas.save();
  canvas.translate(at(actor.x, step), at(actor.y, step));
  canvas.rotate(at(actor.heading, step));
  canvas.fillStyle = colours[actor.role];
  canvas.strokeStyle = colours.card;
  canvas.lineWidth = 1.2 / camera.zoom;
  const draw = SHAPES[content.manners[actor.kind]] || (actor.role === "occluder" ? drawProp : drawVehicle);
  draw(Math.max(actor.length, 5 / camera.zoom), Math.max(actor.width, 4 / camera.zoom));
  canvas.restore();
}

function drawVehicle(length, width) {
  canvas.beginPath();
  canvas.roundRect(-length / 2, -width / 2, length, width, Math.min(width * 0.28, 0.6));
  canvas.fill(); canvas.stroke();
  canvas.fillStyle = "rgba(255,255,255,.82)";
  const tip = length * 0.36, base = tip - width * 0.42, half = width * 0.3;
  path([[tip, 0], [base, half], [base, -half]], true);
  canvas.fill();
}

function drawTwoWheeler(length, width) {
  const thick = width * 0.45;
  canvas.beginPath(); canvas.roundRect(-length / 2, -thick / 2, length, thick, thick / 2); canvas.fill(); canvas.stroke();
  canvas.beginPath(); canvas.roundRect(length * 0.18, -width / 2, thick * 0.5, width, thick * 0.2); canvas.fill();
  canvas.beginPath(); canvas.arc(-length * 0.05, 0, width * 0.32, 0, 7); canvas.fill(); canvas.stroke();
}

function drawWalker(length, width) {
  const radius = Math.max(width / 2, length / 2, 5 / camera.zoom);
  path([[radius * 2.1, 0], [radius * 0.7, radius * 0.75], [radius * 0.7, -radius * 0.75]], true);
  canvas.fill();
  canvas.beginPath(); canvas.arc(0, 0, Math.max(radius, 6 / camera.zoom), 0, 7); canvas.fill(); canvas.stroke();
}

function drawProp(length, width) {
  canvas.beginPath(); canvas.rect(-length / 2, -width / 2, length, width); canvas.fill(); canvas.stroke();
  canvas.save(); canvas.clip();
  canvas.strokeStyle = "rgba(0,0,0,.22)"; canvas.lineWidth = 0.12;
  for (let x = -length; x < length; x += 0.5) { path([[x, -width / 2], [x + width, width / 2]]); canvas.stroke(); }
  canvas.restore();
}

/** Larger ones first, so that nobody is hidden under whom they meet; the star lies between the two that touch. */
function drawActors() {
  const order = [...drive.actors].sort((a, b) => b.length * b.width - a.length * a.width);
  const above = order[Math.max(order.indexOf(ego()), order.indexOf(met()))];
  for (const actor of order) {
    if (actor === above) drawCrash();
    drawActor(actor);
  }
}

const starRadius = () => Math.max(1.6, 17 / camera.zoom); // [m]

function drawCrash() {
  const hit = crash();
  if (!hit || !hit.at || step < hit.step - 0.5) return;
  const [x, y] = hit.at, radius = starRadius();
  const star = [];
  for (let i = 0; i < 20; i++) {
    const angle = i * Math.PI / 10, r = i % 2 ? radius * 0.5 : radius;
    star.push([x + r * Math.cos(angle), y + r * Math.sin(angle)]);
  }
  canvas.fillStyle = "#ffd23f";
  canvas.strokeStyle = colours.hit;
  canvas.lineWidth = Math.max(0.2, 2 / camera.zoom);
  canvas.lineJoin = "round";
  canvas.globalAlpha = 0.92;
  path(star, true); canvas.fill(); canvas.stroke();
  canvas.globalAlpha = 1;
}

/** Names and the speed of the impact, each beside what it tells of and none over another; screen pixels. */
function drawLabels(width, height) {
  const toScreen = (x, y) => [(x - camera.x) * camera.zoom + width / 2, height / 2 - (y - camera.y) * camera.zoom];
  const labels = [], taken = [];
  for (const actor of drive.actors) {
    if (camera.zoom < 3 || (actor.role === "background" && actor !== met())) continue;
    const [x, y] = toScreen(at(actor.x, step), at(actor.y, step)), heading = at(actor.heading, step);
    const long = Math.max(actor.length * camera.zoom, 12) / 2, wide = Math.max(actor.width * camera.zoom, 12) / 2;
    const w = long * Math.abs(Math.cos(heading)) + wide * Math.abs(Math.sin(heading));
    const h = long * Math.abs(Math.sin(heading)) + wide * Math.abs(Math.cos(heading));
    if (x < -w || x > width + w || y < -h || y > height + h) continue;
    taken.push([x - w, y - h, x + w, y + h]);
    labels.push({ x, y, w, h, text: called(actor), side: actor });
  }
  const hit = crash();
  if (hit && hit.at && step >= hit.step - 0.5) {
    const [x, y] = toScreen(...hit.at), r = starRadius() * camera.zoom;
    taken.push([x - r, y - r, x + r, y + r]);
    labels.push({ x, y, w: r, h: r, text: "impact " + hit.impact.toFixed(1) + " m/s", side: hit, colour: colours.hit });
  }
  canvas.textAlign = "center";
  canvas.textBaseline = "middle";
  canvas.font = "600 12px system-ui, sans-serif";
  canvas.lineJoin = "round";
  for (const label of labels) {
    const [x, y] = place(label, canvas.measureText(label.text).width / 2 + 4, 9, taken, width, height);
    canvas.lineWidth = 4;
    canvas.strokeStyle = colours.ground; canvas.fillStyle = label.colour || colours.label;
    canvas.strokeText(label.text, x, y); canvas.fillText(label.text, x, y);
  }
  canvas.textBaseline = "alphabetic";
}

const SIDES = [[0, -1], [1, 0], [-1, 0], [0, 1], [1, -1], [-1, -1], [1, 1], [-1, 1]];
const sides = new WeakMap(); // where each label was last, so that it does not jump while there is room

/** The middle of a label of half size `w`, `h` where it covers least; that place is then taken. */
function place(label, w, h, taken, width, height) {
  let best = null, least = Infinity;
  const last = sides.get(label.side);
  for (const far of [2, 18, 36]) {
    for (const side of last ? [last, ...SIDES] : SIDES) {
      const x = label.x + side[0] * (label.w + w + far), y = label.y + side[1] * (label.h + h + far);
      const box = [x - w, y - h, x + w, y + h];
      const outside = x < w + 4 || x > width - w - 4 || y < h + 46 || y > height - h - 40; // clear of the buttons
      const cost = taken.reduce((sum, other) => sum + overlap(box, other), outside ? 1e6 : 0) + far / 100;
      if (cost < least) { least = cost; best = { x, y, side, box }; }
    }
    if (least < 1) break;
  }
  sides.set(label.side, best.side);
  taken.push(best.box);
  return [best.x, best.y];
}

const overlap = (a, b) =>
  Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));

function drawScale(height) {
  const metres = [1, 2, 5, 10, 20, 50, 100, 200].find((m) => m * camera.zoom > 60) || 500;
  canvas.textAlign = "left";
  canvas.font = "11px system-ui, sans-serif";
  canvas.fillStyle = canvas.strokeStyle = colours.label;
  canvas.lineWidth = 2;
  canvas.beginPath();
  canvas.moveTo(14, height - 24); canvas.lineTo(14, height - 18); canvas.lineTo(14 + metres * camera.zoom, height - 18);
  canvas.lineTo(14 + metres * camera.zoom, height - 24); canvas.stroke();
  canvas.fillText(metres + " m", 19, height - 24);
}

function draw() {
  const [width, height] = fit(view, canvas);
  if (camera.follow) aim(width, height);
  canvas.fillStyle = colours.ground;
  canvas.fillRect(0, 0, width, height);
  canvas.save();
  canvas.translate(width / 2, height / 2);
  canvas.scale(camera.zoom, -camera.zoom);
  canvas.translate(-camera.x, -camera.y);
  drawMap(); drawRoute(); drawSignals();
  drive.actors.forEach(drawTrail);
  drawActors();
  canvas.restore();
  drawLabels(width, height);
  drawScale(height);
  drawSpeeds();
  tell();
}

const INSET = 8; // half the thumb of the slider, so that chart and slider agree

function drawSpeeds() {
  const [width, height] = fit(speeds, chart);
  const count = drive.steps, lines = [ego(), ...adversaries()];
  const top = Math.max(1, ...lines.map((a) => Math.max(...a.speed.map(Math.abs))));
  const x = (i) => INSET + (count > 1 ? i / (count - 1) : 0) * (width - 2 * INSET);
  const y = (v) => height - 4 - Math.abs(v) / top * (height - 20);
  chart.clearRect(0, 0, width, height);
  chart.font = "11px system-ui, sans-serif";
  chart.fillStyle = colours.soft;
  chart.fillText("speed, to " + top.toFixed(0) + " m/s", INSET, 11);
  chart.strokeStyle = colours.line; chart.lineWidth = 1;
  chart.beginPath(); chart.moveTo(INSET, height - 3.5); chart.lineTo(width - INSET, height - 3.5); chart.stroke();
  for (const event of drive.events) {
    chart.strokeStyle = event.kind === "collision" ? colours.hit : colours.soft;
    chart.lineWidth = event.kind === "collision" ? 2 : 1;
    chart.beginPath(); chart.moveTo(x(event.step), 14); chart.lineTo(x(event.step), height - 4); chart.stroke();
  }
  chart.lineWidth = 1.8;
  chart.lineJoin = "round";
  for (const actor of lines) {
    chart.strokeStyle = colours[actor.role];
    chart.beginPath();
    actor.speed.forEach((v, i) => (i ? chart.lineTo(x(i), y(v)) : chart.moveTo(x(i), y(v))));
    chart.stroke();
  }
  chart.strokeStyle = colours.ink; chart.lineWidth = 1;
  chart.beginPath(); chart.moveTo(x(step), 0); chart.lineTo(x(step), height); chart.stroke();
}

// --- words beside the picture --------------------------------------------------------------------------------------

function element(name, text, className) {
  const made = document.createElement(name);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

function tell() {
  const seconds = (step * drive.dt).toFixed(1), total = ((drive.steps - 1) * drive.dt).toFixed(1);
  $("clock").textContent = seconds + " s of " + total + " s";
  $("time").value = Math.round(step);
  $("time").setAttribute("aria-valuetext", seconds + " seconds");
  $("play").textContent = playing ? "Pause" : step >= drive.steps - 1 ? "Replay" : "Play";
  const gauges = [[called(ego()), at(ego().speed, step).toFixed(1) + " m/s"]];
  const other = met();
  if (other) {
    const gap = Math.hypot(at(other.x, step) - at(ego().x, step), at(other.y, step) - at(ego().y, step));
    gauges.push([called(other), at(other.speed, step).toFixed(1) + " m/s"], ["between centres", gap.toFixed(1) + " m"]);
  }
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
  const how = event.kind === "collision" ? ", " + event.side + ", " + event.impact.toFixed(1) + " m/s" : "";
  return (event.step * drive.dt).toFixed(1) + " s  " + what + how;
}

function introduce(scene) {
  $("scene-name").textContent = scene.label;
  const careful = { true: "; a careful driver avoids it", false: "; a careful driver does not avoid it" }[scene.avoidable] || "";
  $("scene-outcome").textContent = scene.collision ? "collision, " + scene.impact.toFixed(1) + " m/s" + careful : scene.ending;
  $("scene-outcome").className = "chip" + (scene.collision ? " hit" : "");
  $("time").max = drive.steps - 1;
  $("events").replaceChildren(...drive.events.map((event) => {
    const button = element("button", eventWords(event), event.kind === "collision" ? "hit" : "");
    button.type = "button";
    button.addEventListener("click", () => seek(Math.max(event.step - 1 / drive.dt, 0)));
    button.title = "Go to one second before";
    return button;
  }));
  $("metrics").replaceChildren(...scene.metrics.map((metric) => {
    const entry = document.createElement("div");
    entry.append(element("dt", metric.name), element("dd", metric.value), element("dd", metric.note, "note"));
    return entry;
  }));
  for (const row of document.querySelectorAll("tr[data-scene]")) {
    if (row.dataset.scene === scene.id) row.setAttribute("aria-current", "true");
    else row.removeAttribute("aria-current");
  }
}

// --- camera --------------------------------------------------------------------------------------------------------

/** Ego and whom it meets, the nearer the larger; where they are too far apart, the ego and a part of the way there. */
function aim(width, height) {
  const other = met() || ego(), x = at(ego().x, step), y = at(ego().y, step);
  const dx = at(other.x, step) - x, dy = at(other.y, step) - y, margin = 16; // [m]
  const near = Math.max(width / 44, 8), far = Math.max(width / 130, 4); // pixels a metre
  const fits = Math.min(width / (Math.abs(dx) + margin), height / (Math.abs(dy) + margin));
  const share = 0.5 * Math.min(1, fits / far) ** 2;
  camera.zoom = Math.min(Math.max(Math.min(Math.max(fits, far), near) * camera.closer, 0.5), 60);
  camera.x = x + share * dx;
  camera.y = y + share * dy;
}

function follow(on) {
  camera.follow = on;
  $("follow").setAttribute("aria-pressed", String(on));
}

function zoomBy(factor) {
  if (camera.follow) camera.closer *= factor;
  camera.zoom = Math.min(Math.max(camera.zoom * factor, 0.5), 60);
  draw();
}

function showWhole() {
  const actors = [ego(), ...adversaries()];
  const xs = actors.flatMap((a) => [...a.x]), ys = actors.flatMap((a) => [...a.y]), margin = 12;
  const west = Math.min(...xs) - margin, east = Math.max(...xs) + margin;
  const south = Math.min(...ys) - margin, north = Math.max(...ys) + margin;
  follow(false);
  camera.x = (west + east) / 2;
  camera.y = (south + north) / 2;
  camera.zoom = Math.min(view.clientWidth / (east - west), view.clientHeight / (north - south), 30);
  draw();
}

// --- time ----------------------------------------------------------------------------------------------------------

function seek(when) {
  step = Math.min(Math.max(when, 0), drive.steps - 1);
  draw();
}

/** A timer and not animation frames: those stop where nothing is painted, as in headless browsers. */
function play(on) {
  if (on && step >= drive.steps - 1) step = 0;
  clearInterval(timer);
  playing = on;
  last = performance.now();
  if (on) timer = setInterval(tick, 1000 / 60);
  draw();
}

function tick() {
  const now = performance.now();
  step += Math.min(now - last, 250) / 1000 * Number($("rate").value) / drive.dt;
  last = now;
  if (step < drive.steps - 1) draw();
  else pause();
}

function pause() {
  clearInterval(timer);
  playing = false;
  seek(step);
}

function choose(index, start) {
  shown = (index + scenes.length) % scenes.length;
  drive = unpackDrive(scenes[shown].drive);
  const hit = crash();
  step = hit ? Math.max(hit.step - LEAD / drive.dt, 0) : 0;
  if (hit && !start) step = hit.step; // a still picture shows what happened
  follow(true);
  camera.closer = 1;
  introduce(scenes[shown]);
  play(start);
}

// --- hands ---------------------------------------------------------------------------------------------------------

const KEYS = {
  " ": () => play(!playing), k: () => play(!playing),
  ArrowLeft: () => { pause(); seek(Math.ceil(step) - 1); },
  ArrowRight: () => { pause(); seek(Math.floor(step) + 1); },
  Home: () => seek(0), End: () => seek(drive.steps - 1),
  f: () => { follow(!camera.follow); draw(); }, 0: showWhole,
  "+": () => zoomBy(1.25), "=": () => zoomBy(1.25), "-": () => zoomBy(0.8),
  n: () => choose(shown + 1, true), p: () => choose(shown - 1, true),
};

function listen() {
  $("play").addEventListener("click", () => play(!playing));
  $("time").addEventListener("input", (event) => { pause(); seek(Number(event.target.value)); });
  $("follow").addEventListener("click", KEYS.f);
  $("whole").addEventListener("click", showWhole);
  $("closer").addEventListener("click", () => zoomBy(1.25));
  $("wider").addEventListener("click", () => zoomBy(0.8));
  $("next").addEventListener("click", KEYS.n);
  $("previous").addEventListener("click", KEYS.p);
  for (const button of document.querySelectorAll(".play-scene")) {
    button.addEventListener("click", () => {
      choose(scenes.findIndex((scene) => scene.id === button.dataset.scene), true);
      $("replay").scrollIntoView({ block: "start", behavior: calm ? "auto" : "smooth" });
    });
  }
  document.addEventListener("keydown", (event) => {
    const typing = /^(INPUT|SELECT|BUTTON|SUMMARY|TEXTAREA)$/.test(event.target.tagName);
    const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey || (typing && event.key.length !== 1)) return;
    if (typing && event.key === " ") return;
    event.preventDefault();
    act();
  });
  listenToPointer();
  window.addEventListener("resize", draw);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColours(); draw(); });
}

function listenToPointer() {
  let from = null;
  view.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; view.setPointerCapture(event.pointerId); });
  view.addEventListener("pointermove", (event) => {
    if (!from) return;
    follow(false);
    camera.x -= (event.clientX - from[0]) / camera.zoom;
    camera.y += (event.clientY - from[1]) / camera.zoom;
    from = [event.clientX, event.clientY];
    draw();
  });
  for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, () => { from = null; });
  view.addEventListener("wheel", (event) => { // plain scrolling stays with the page
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 300));
  }, { passive: false });
  const jump = (event) => {
    const share = (event.offsetX - INSET) / (speeds.clientWidth - 2 * INSET);
    pause();
    seek(share * (drive.steps - 1));
  };
  speeds.addEventListener("pointerdown", jump);
  speeds.addEventListener("pointermove", (event) => { if (event.buttons) jump(event); });
}

/** `report.html#SCENE@SECONDS` opens on that scene, paused at that time; answers whether there was such a link. */
function openLinked() {
  const [id, seconds] = decodeURIComponent(location.hash.slice(1)).split("@");
  const index = scenes.findIndex((scene) => scene.id === id);
  if (index < 0) return false;
  choose(index, false);
  seek((Number(seconds) || 0) / drive.dt);
  return true;
}

const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
if (scenes.length) {
  $("replay").hidden = false;
  readColours();
  listen();
  openLinked() || choose(0, !calm);
}
})();
