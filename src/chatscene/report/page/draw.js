// --- state ---------------------------------------------------------------------------------------------------------

const view = $("view"), speeds = $("speeds");
const chart = speeds.getContext("2d");
let canvas = view.getContext("2d"); // what is drawn on, and from where: `elsewhere` changes both for small pictures
let camera = { x: 0, y: 0, zoom: 8, turn: 0, closer: 1, follow: true, up: false, ghost: true };
let shown = 0, drive = null, step = 0, playing = false, timer = 0, last = 0, until = 0;
let still = false; // whether the moment that says most is shown, and nobody has touched it
let colours = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["ego", "adversary", "background", "occluder", "ground", "sidewalk", "shoulder", "cycle", "road", "paint", "centre",
    "stop", "miss", "route", "label", "green", "yellow", "red", "edge", "card", "ink", "soft", "line", "hit"]) {
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
const ghost = () => (camera.ghost && drive.ghost) || null;

/** Who the ego meets: whom it collides with, else the adversary. */
const met = () => drive.actors.find((a) => a.name === crash()?.other) || adversaries()[0];

/** What an actor is called: by what it is, and the ego by who drives. */
const called = (actor) => (actor.role === "ego" ? "ego: " + content.ego : content.called[actor.role][actor.kind]);

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
  fillAll(map.driveways, colours.road);
  fillAll(map.cycleLanes, colours.cycle);
  fillAll(map.roads, colours.road);
  fillAll(map.junctions, colours.road);
  canvas.fillStyle = colours.paint;
  for (const area of [...map.crosswalks, ...map.rails]) canvas.fill(area);
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
    const colour = colours[names[signal.states[Math.min(Math.floor(step), signal.states.length - 1)]]] || colours.soft;
    for (const [paint, wider] of [[colours.edge, 1.5 / camera.zoom], [colour, 0]]) { // yellow is seen by its edge alone
      canvas.strokeStyle = canvas.fillStyle = paint;
      canvas.lineWidth = Math.max(0.6, 3 / camera.zoom) + 2 * wider;
      path([[x0, y0], [x1, y1]]); canvas.stroke();
      if (signal.role !== "ego") continue;
      canvas.beginPath(); canvas.arc(x0, y0, Math.max(0.7, 5 / camera.zoom) + wider, 0, 7); canvas.fill();
    }
  }
}

function drawTrail(actor) {
  const end = Math.min(Math.floor(step), actor.x.length - 1);
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

/** Another ego in the same scene, and whom it meets there: outlines, since they were not in this drive. */
function drawGhost() {
  if (!ghost()) return;
  canvas.setLineDash([0.6, 0.4]);
  ghost().actors.forEach(drawTrail);
  for (const actor of ghost().actors) {
    const length = Math.max(actor.length, 8 / camera.zoom), width = Math.max(actor.width, 8 / camera.zoom);
    canvas.save();
    canvas.translate(at(actor.x, step), at(actor.y, step));
    canvas.rotate(at(actor.heading, step));
    canvas.strokeStyle = canvas.fillStyle = colours[actor.role];
    canvas.lineWidth = Math.max(0.18, 2 / camera.zoom);
    canvas.beginPath(); canvas.roundRect(-length / 2, -width / 2, length, width, Math.min(width, length) * 0.25);
    canvas.globalAlpha = 0.18; canvas.fill();
    canvas.globalAlpha = 1; canvas.stroke();
    canvas.restore();
  }
  canvas.setLineDash([]);
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

/** Paint with x, y in metres of the map, turned as the camera is. */
function onMap(width, height, paint) {
  canvas.fillStyle = colours.ground;
  canvas.fillRect(0, 0, width, height);
  canvas.save();
  canvas.translate(width / 2, height / 2);
  canvas.scale(camera.zoom, -camera.zoom);
  canvas.rotate(camera.turn);
  canvas.translate(-camera.x, -camera.y);
  paint();
  canvas.restore();
}

/** Draw on another canvas, from another place. */
function elsewhere(element, from, paint) {
  const before = [canvas, camera], context = element.getContext("2d");
  const [width, height] = fit(element, context);
  canvas = context;
  camera = from;
  onMap(width, height, paint);
  [canvas, camera] = before;
}

function draw() {
  const [width, height] = fit(view, canvas);
  camera.turn = camera.up ? Math.PI / 2 - at(ego().heading, step) : turnFor(width, height);
  if (camera.follow) aim(width, height);
  onMap(width, height, () => {
    drawMap(); drawRoute(); drawSignals();
    drive.actors.forEach(drawTrail);
    drawGhost();
    drawActors();
  });
  drawLabels(width, height);
  drawArrows(width, height);
  drawScale(height);
  drawChart();
  tell();
}
