// --- over time -----------------------------------------------------------------------------------------------------

const INSET = 8; // half the thumb of the slider, so that chart and slider agree
const FAR = 40, SOON = 10; // [m], [s] at the upper edge of the gap and of the time to collision

/** Speeds, and below them the gap and the time to collision between the ego and whom it meets. */
function drawChart() {
  const [width, height] = fit(speeds, chart), count = drive.shown;
  const x = (i) => INSET + (count > 1 ? i / (count - 1) : 0) * (width - 2 * INSET);
  chart.clearRect(0, 0, width, height);
  for (const [at, , kind] of moments()) {
    chart.strokeStyle = kind === "collision" ? colours.hit : colours.soft;
    chart.lineWidth = kind === "collision" ? 2 : 1;
    chart.setLineDash(kind === "mark" ? [3, 3] : []);
    chart.beginPath(); chart.moveTo(x(at), 0); chart.lineTo(x(at), height); chart.stroke();
  }
  const lines = [ego(), met() || ego(), ...adversaries()].map((a) => [a.speed.map(Math.abs), colours[a.role], []]);
  if (ghost()) lines.push([ghost().actors[0].speed.map(Math.abs), colours.ego, [4, 3]]);
  const top = Math.max(1, ...lines.map(([values]) => Math.max(...values)));
  const near = drive.near.gap.length ? Math.min(FAR, Math.max(2, ...drive.near.gap)) : 0;
  plot(x, 0, height * 0.5, top, "speed, to " + kmh(top), lines);
  plot(x, height * 0.5, height * 0.25, near, "gap, to " + near.toFixed(0) + " m", [[drive.near.gap, colours.ink, []]]);
  plot(x, height * 0.75, height * 0.25, SOON, "time to collision, to " + SOON + " s", [[drive.near.time, colours.ink, []]]);
  chart.strokeStyle = colours.ink; chart.lineWidth = 1;
  chart.beginPath(); chart.moveTo(x(step), 0); chart.lineTo(x(step), height); chart.stroke();
}

/** One band of the chart; a line breaks where its value is negative. */
function plot(x, above, tall, top, title, lines) {
  const y = (v) => above + tall - 4 - Math.min(v / top, 1) * (tall - 22); // below the title
  chart.setLineDash([]);
  chart.strokeStyle = colours.line; chart.lineWidth = 1;
  chart.beginPath(); chart.moveTo(INSET, y(0)); chart.lineTo(x(drive.shown - 1), y(0)); chart.stroke();
  chart.lineWidth = 1.8;
  chart.lineJoin = "round";
  for (const [values, colour, dash] of lines) {
    let on = false;
    chart.strokeStyle = colour;
    chart.setLineDash(dash);
    chart.beginPath();
    values.forEach((v, i) => {
      if (v < 0) on = false;
      else if (on) chart.lineTo(x(i), y(v));
      else { chart.moveTo(x(i), y(v)); on = true; }
    });
    chart.stroke();
  }
  chart.setLineDash([]);
  chart.font = "11px system-ui, sans-serif";
  chart.lineWidth = 3; chart.strokeStyle = colours.card; chart.fillStyle = colours.soft;
  chart.strokeText(title, INSET, above + 11); chart.fillText(title, INSET, above + 11);
}
