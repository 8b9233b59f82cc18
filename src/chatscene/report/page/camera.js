// --- camera --------------------------------------------------------------------------------------------------------

/** A way on the map [m], as the camera sees it: to the right, and up. */
function turned(dx, dy) {
  const cos = Math.cos(camera.turn), sin = Math.sin(camera.turn);
  return [dx * cos - dy * sin, dx * sin + dy * cos];
}

/** The way back: from to the right and up, to the map. */
function turnedBack(u, v) {
  const cos = Math.cos(camera.turn), sin = Math.sin(camera.turn);
  return [u * cos + v * sin, v * cos - u * sin];
}

/** The ego's road lies along the longer side of the picture, so that it fills it; it does not turn while time goes on. */
function turnFor(width, height) {
  return (width >= height ? 0 : Math.PI / 2) - at(ego().heading, firstStep());
}

/** Ego and whom it meets, the nearer the larger; where they are too far apart, the ego and a part of the way there. */
function aim(width, height) {
  const other = met() || ego(), x = at(ego().x, step), y = at(ego().y, step);
  const dx = at(other.x, step) - x, dy = at(other.y, step) - y, margin = 16; // [m]
  const [u, v] = turned(dx, dy);
  const near = Math.max(Math.max(width, height) / 44, 8), far = Math.max(width / 130, 4); // pixels a metre
  const fits = Math.min(width / (Math.abs(u) + margin), height / (Math.abs(v) + margin));
  const share = 0.5 * Math.min(1, fits / far) ** 2;
  camera.zoom = Math.min(Math.max(Math.min(Math.max(fits, far), near) * camera.closer, 0.5), 60);
  camera.x = x + share * dx;
  camera.y = y + share * dy;
}

function follow(on) {
  camera.follow = on;
  $("follow").setAttribute("aria-pressed", String(on));
}

function headUp(on) {
  camera.up = on;
  $("heading").setAttribute("aria-pressed", String(on));
  draw();
}

function showGhost(on) {
  camera.ghost = on;
  $("ghost").setAttribute("aria-pressed", String(on));
  draw();
}

function zoomBy(factor) {
  if (camera.follow) camera.closer *= factor;
  camera.zoom = Math.min(Math.max(camera.zoom * factor, 0.5), 60);
  draw();
}

/** Hold points of the map [m] in a picture of some size. */
function hold(points, width, height, margin) {
  const seen = points.map(([x, y]) => turned(x, y));
  const us = seen.map((p) => p[0]), vs = seen.map((p) => p[1]);
  const left = Math.min(...us) - margin, right = Math.max(...us) + margin;
  const low = Math.min(...vs) - margin, high = Math.max(...vs) + margin;
  [camera.x, camera.y] = turnedBack((left + right) / 2, (low + high) / 2);
  camera.zoom = Math.min(width / (right - left), height / (high - low), 30);
}

const pointsOf = (actor) => Array.from(actor.x, (x, i) => [x, actor.y[i]]);

function showWhole() {
  follow(false);
  hold([ego(), ...adversaries()].flatMap(pointsOf), view.clientWidth, view.clientHeight, 12);
  draw();
}
