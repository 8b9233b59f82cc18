// --- all scenes at once --------------------------------------------------------------------------------------------

const unpacked = new Map(); // drives by scene, each unpacked when it is first looked at

function driveOf(scene) {
  if (!unpacked.has(scene.id)) unpacked.set(scene.id, unpackDrive(scene.drive));
  return unpacked.get(scene.id);
}

/** Do something as if another scene were shown, at a moment of it. */
function asIf(index, work) {
  const before = [shown, drive, step];
  shown = index;
  drive = driveOf(scenes[index]);
  step = decisive();
  work();
  [shown, drive, step] = before;
}

/** The moment that says most: the contact, else when something happened, or the two were nearest. */
const decisive = () => drive.span[1];

const COMING = 5, GONE = 2; // [s] before and after the decisive moment that a way is drawn

/** Where somebody was around the decisive moment. */
function wayOf(actor) {
  const from = Math.max(Math.round(decisive() - COMING / drive.dt), 0);
  return pointsOf(actor).slice(from, Math.round(decisive() + GONE / drive.dt) + 1);
}

/** The ways of all scenes of the route that is shown, the shown one on top. */
function drawWays() {
  const ways = $("ways"), route = scenes[shown].route, mine = shown;
  const indices = scenes.map((scene, i) => i).filter((i) => scenes[i].route === route && i !== mine);
  const from = { x: 0, y: 0, zoom: 1, turn: turnFor(ways.clientWidth, ways.clientHeight), ghost: false };
  const points = [], order = [...indices.reverse(), mine];
  for (const i of order) asIf(i, () => points.push(...[ego(), met() || ego()].flatMap(wayOf)));
  const main = camera;
  camera = from;
  hold(points, ways.clientWidth, ways.clientHeight, 8);
  camera = main;
  elsewhere(ways, from, () => {
    drawMap();
    for (const i of order) asIf(i, () => {
      const hit = crash(), colour = hit ? colours.hit : colours.miss;
      canvas.strokeStyle = canvas.fillStyle = colour;
      canvas.globalAlpha = i === mine ? 1 : 0.55;
      for (const actor of [ego(), met()].filter(Boolean)) {
        canvas.lineWidth = (i === mine ? 3 : 1.2) / camera.zoom;
        canvas.setLineDash(actor === ego() ? [] : [4 / camera.zoom, 3 / camera.zoom]);
        path(wayOf(actor)); canvas.stroke();
      }
      canvas.setLineDash([]);
      if (hit && hit.at) { canvas.beginPath(); canvas.arc(...hit.at, (i === mine ? 6 : 3.5) / camera.zoom, 0, 7); canvas.fill(); }
      canvas.globalAlpha = 1;
    });
  });
  $("all-route").textContent = order.length + " scenes on " + route.split("/").pop().replace("-", " ") + ".";
}

/** A picture of the decisive moment in a row of the table. */
function drawThumbnail(element, index) {
  asIf(index, () => {
    const from = { x: 0, y: 0, zoom: 5, turn: -at(ego().heading, firstStep()), ghost: false };
    const main = camera;
    camera = from;
    hold([ego(), met() || ego()].map((a) => [at(a.x, step), at(a.y, step)]), 88, 48, 8);
    camera = main;
    elsewhere(element, from, () => { drawMap(); drive.actors.forEach(drawTrail); drawActors(); });
  });
}

function drawThumbnails() {
  const watch = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) drawThumbnail(entry.target, Number(entry.target.dataset.index));
  });
  for (const button of document.querySelectorAll(".play-scene")) {
    const index = scenes.findIndex((scene) => scene.id === button.dataset.scene);
    const picture = Object.assign(document.createElement("canvas"), { className: "thumbnail" });
    picture.dataset.index = index;
    picture.setAttribute("aria-hidden", "true");
    picture.addEventListener("click", () => button.click());
    button.before(picture);
    watch.observe(picture);
  }
}
