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
  const count = drive.steps, actors = drive.actors.map((a) => unpackActor(a, count));
  const signals = drive.signals.map((s) => ({ ...s, states: s.states.map(([c, n]) => c.repeat(n)).join("") }));
  const near = { gap: unpack(drive.near.gap, 100, count), time: unpack(drive.near.time, 100, count) };
  const ghost = drive.ghost && { ...drive.ghost, actors: drive.ghost.actors.map((a) => unpackActor(a, drive.ghost.steps)) };
  return { ...drive, actors, signals, near, ghost, shown: Math.max(count, ghost ? ghost.steps : 0) };
}

const unpackActor = (a, count) => ({
  ...a,
  x: unpack(a.x, 100, count), y: unpack(a.y, 100, count),
  heading: unpack(a.heading, 1000, count), speed: unpack(a.speed, 100, count),
});

const map = {
  sidewalks: content.map.sidewalks.map(unpackArea),
  shoulders: content.map.shoulders.map(unpackArea),
  driveways: content.map.driveways.map(unpackArea),
  cycleLanes: content.map.cycle_lanes.map(unpackArea),
  roads: content.map.roads.map(unpackArea),
  junctions: content.map.junctions.map(unpackArea),
  crosswalks: content.map.crosswalks.map(unpackArea),
  rails: content.map.rails.map(unpackArea),
  stops: content.map.stop_lines.map(unpackLine),
  lines: content.map.lane_boundaries.map((line) => ({ kind: line.kind, points: unpackLine(line.points) })),
  routes: Object.fromEntries(Object.entries(content.map.routes).map(([name, line]) => [name, unpackLine(line)])),
};

