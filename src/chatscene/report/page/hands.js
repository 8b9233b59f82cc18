// --- time ----------------------------------------------------------------------------------------------------------

function seek(when) {
  still = false;
  step = Math.min(Math.max(when, 0), drive.shown - 1);
  draw();
}

/** A timer and not animation frames: those stop where nothing is painted, as in headless browsers. */
function play(on) {
  if (on && (still || step >= lastStep())) step = firstStep();
  still = still && !on;
  until = lastStep();
  clearInterval(timer);
  playing = on;
  last = performance.now();
  if (on) timer = setInterval(tick, 1000 / 60);
  draw();
}

function tick() {
  const now = performance.now();
  step = Math.min(step + Math.min(now - last, 250) / 1000 * Number($("rate").value) / drive.dt, until);
  last = now;
  if (step < until) draw();
  else pause();
}

function pause() {
  clearInterval(timer);
  playing = false;
  seek(step);
}

/** A replay ends soon after what happened, before it would be a still. The slider goes on to the end. */
function lastStep() {
  const whole = drive.shown - 1, last = drive.span[2];
  return (crash() && drive.ghost && camera.ghost) || step > last ? whole : last;
}

/** A replay begins shortly before what happened. */
const firstStep = () => drive.span[0];

function choose(index, start) {
  shown = (index + scenes.length) % scenes.length;
  drive = driveOf(scenes[shown]);
  step = start ? firstStep() : decisive(); // a still picture shows what happened
  still = !start;
  follow(true);
  camera.closer = 1;
  introduce(scenes[shown]);
  drawWays();
  play(start);
}

// --- hands ---------------------------------------------------------------------------------------------------------

const KEYS = {
  " ": () => play(!playing), k: () => play(!playing),
  ArrowLeft: () => { pause(); seek(Math.ceil(step) - 1); },
  ArrowRight: () => { pause(); seek(Math.floor(step) + 1); },
  Home: () => seek(0), End: () => seek(drive.shown - 1),
  f: () => { follow(!camera.follow); draw(); }, 0: showWhole,
  h: () => headUp(!camera.up), g: () => showGhost(!camera.ghost),
  "+": () => zoomBy(1.25), "=": () => zoomBy(1.25), "-": () => zoomBy(0.8),
  n: () => choose(shown + 1, true), p: () => choose(shown - 1, true),
};

function listen() {
  $("play").addEventListener("click", () => play(!playing));
  $("time").addEventListener("input", (event) => { pause(); seek(Number(event.target.value)); });
  $("follow").addEventListener("click", KEYS.f);
  $("whole").addEventListener("click", showWhole);
  $("heading").addEventListener("click", KEYS.h);
  $("ghost").addEventListener("click", KEYS.g);
  $("closer").addEventListener("click", () => zoomBy(1.25));
  $("wider").addEventListener("click", () => zoomBy(0.8));
  $("next").addEventListener("click", KEYS.n);
  $("previous").addEventListener("click", KEYS.p);
  for (const one of document.querySelectorAll(".play-scene, .outcomes circle")) {
    one.addEventListener("click", () => {
      const index = scenes.findIndex((scene) => scene.id === one.dataset.scene);
      if (index < 0) return; // left out of the page
      choose(index, !calm);
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
  window.addEventListener("resize", () => { draw(); drawWays(); });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColours(); draw(); drawWays(); });
}

function listenToPointer() {
  let from = null;
  view.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; view.setPointerCapture(event.pointerId); });
  view.addEventListener("pointermove", (event) => {
    if (!from) return;
    follow(false);
    const [dx, dy] = turnedBack((event.clientX - from[0]) / camera.zoom, (from[1] - event.clientY) / camera.zoom);
    camera.x -= dx;
    camera.y -= dy;
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
    seek(share * (drive.shown - 1));
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
offerCode();
listenToTable();
if (scenes.length) {
  $("replay").hidden = $("all").hidden = false;
  readColours();
  listen();
  drawThumbnails();
  openLinked() || choose(0, !calm);
}
