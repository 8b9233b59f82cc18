/** A point of the map [m] in screen pixels. */
function onScreen(x, y, width, height) {
  const [u, v] = turned(x - camera.x, y - camera.y);
  return [width / 2 + u * camera.zoom, height / 2 - v * camera.zoom];
}

/** Names and the speed of the impact, each beside what it tells of and none over another; screen pixels. */
function drawLabels(width, height) {
  const labels = [], taken = [];
  for (const actor of [...drive.actors, ...(ghost() ? ghost().actors.slice(0, 1) : [])]) {
    if (camera.zoom < 3 || (actor.role === "background" && actor !== met())) continue;
    const [x, y] = onScreen(at(actor.x, step), at(actor.y, step), width, height);
    const heading = at(actor.heading, step) + camera.turn, other = !drive.actors.includes(actor);
    const long = Math.max(actor.length * camera.zoom, 12) / 2, wide = Math.max(actor.width * camera.zoom, 12) / 2;
    const w = long * Math.abs(Math.cos(heading)) + wide * Math.abs(Math.sin(heading));
    const h = long * Math.abs(Math.sin(heading)) + wide * Math.abs(Math.cos(heading));
    if (x < -w || x > width + w || y < -h || y > height + h) continue;
    taken.push([x - w, y - h, x + w, y + h]);
    labels.push({ x, y, w, h, text: other ? content.beside.ego : called(actor), side: actor });
  }
  const hit = crash();
  if (hit && hit.at && step >= hit.step - 0.5) {
    const [x, y] = onScreen(...hit.at, width, height), r = starRadius() * camera.zoom;
    taken.push([x - r, y - r, x + r, y + r]);
    labels.push({ x, y, w: r, h: r, text: "impact at " + kmh(hit.impact), side: hit, colour: colours.hit });
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

/** At the edge, where those are who play a part and are out of the picture. */
function drawArrows(width, height) {
  for (const actor of new Set([ego(), met(), ...adversaries()].filter(Boolean))) {
    const [x, y] = onScreen(at(actor.x, step), at(actor.y, step), width, height);
    if (x >= 0 && x <= width && y >= 0 && y <= height) continue;
    const dx = x - width / 2, dy = y - height / 2, angle = Math.atan2(dy, dx);
    const share = Math.min((width / 2 - 22) / Math.abs(dx || 1), (height / 2 - 54) / Math.abs(dy || 1));
    const ex = width / 2 + dx * share, ey = height / 2 + dy * share;
    const away = Math.hypot(at(actor.x, step) - at(ego().x, step), at(actor.y, step) - at(ego().y, step));
    canvas.save();
    canvas.translate(ex, ey); canvas.rotate(angle);
    canvas.fillStyle = colours[actor.role]; canvas.strokeStyle = colours.ground; canvas.lineWidth = 2;
    path([[14, 0], [-6, 9], [-6, -9]], true); canvas.stroke(); canvas.fill();
    canvas.restore();
    canvas.font = "600 12px system-ui, sans-serif";
    canvas.textAlign = ex > width - 90 ? "right" : ex < 90 ? "left" : "center";
    canvas.lineWidth = 4; canvas.strokeStyle = colours.ground; canvas.fillStyle = colours.label;
    const text = called(actor) + (actor === ego() ? "" : ", " + away.toFixed(0) + " m");
    const ty = ey + (ey > height / 2 ? -16 : 26);
    canvas.strokeText(text, ex, ty); canvas.fillText(text, ex, ty);
  }
}

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
  canvas.save(); // north
  canvas.translate(24, height - 54); canvas.rotate(-camera.turn);
  path([[0, -12], [5, 4], [0, 1], [-5, 4]], true); canvas.fill();
  canvas.textAlign = "center"; canvas.fillText("N", 0, 15);
  canvas.restore();
}

