// The pictures of the loop: gain, phase, |S|, closed loop with one cursor, and the Nyquist curve. The loop before the first
// change is grey.
"use strict";

const COLOURS = ["#2f81d8", "#c0661a", "#0c8563", "#a8458f"];
const GREY = "#8a8f94";
const plots = new Map();

async function showLoop() {
  const axis = state.axis;
  if (!axis) return clearLoop();
  const { data } = await ask({ command: "loop", axis });
  if (axis === state.axis) drawLoop(data);
}

/** Draws the loop of the axis; null: no stage closes one. */
function drawLoop(data) {
  const axis = state.axis;
  state.loop = data;
  const before = state.before.get(axis);
  if (before && !before.loop) before.loop = data;
  if (!data) return clearLoop("No stage of this axis closes a loop over the motor: there is nothing to draw.");
  fill($("headlines"), ...data.drives.flatMap((drive, n) => [n ? make("br") : "", drive.headline]));
  const old = before.loop === data ? null : before.loop;
  draw("gain", "Gain [dB]", curvesOf(data, "gain"), old && curvesOf(old, "gain"), [-60, 30]);
  draw("phase", "Phase [deg]", curvesOf(data, "phase"), old && curvesOf(old, "phase"), [-180, 180]);
  draw("sensitivity", "|S| [dB]", ofDrives(data, "sensitivity"), old && ofDrives(old, "sensitivity"), [-30, 15]);
  draw("closed", "Closed loop T [dB]", ofDrives(data, "closed"), old && ofDrives(old, "closed"), [-60, 20]);
  if (isShown("nyquist", data.nyquist) && $("nyquist")) return;
  const image = picture(data.nyquist, `Nyquist curve of the loop of axis ${axis}`);
  if ($("nyquist")) $("nyquist").replaceChildren(image);
  else $("pictures").append(make("div", { id: "nyquist" }, image));
}

function clearLoop(why = "") {
  state.loop = null;
  fill($("headlines"), why);
  plots.clear();
  fill($("pictures"));
}

/** The curves of a picture: frequencies, and a row for each name. */
function curvesOf(loop, what) {
  const stages = loop.stages.map((stage) => ({ name: `stage ${stage.stage}`, values: stage[what] }));
  return { hz: loop.hz, rows: [...stages, { name: `L, ${loop.drives[0].drive}`, values: loop.drives[0][what] }] };
}

function ofDrives(loop, what) {
  return { hz: loop.hz, rows: loop.drives.map((drive) => ({ name: drive.drive, values: drive[what] })) };
}

/** Both versions over all their frequencies: uPlot joins them. */
function joined(now, old) {
  const one = (curves) => [curves.hz, ...curves.rows.map((row) => row.values)];
  return old ? uPlot.join([one(old), one(now)]) : one(now);
}

/** Draws a picture; the curves of before are added to one that is there, which is sooner done than another one. */
function draw(id, title, now, old, scale) {
  const data = joined(now, old);
  const known = plots.get(id);
  const key = [state.axis, ...now.rows.map((row) => row.name)].join("|");
  const before = (old?.rows ?? []).map((row) => row.name).join("|");
  if (known?.key !== key || (known.before && known.before !== before)) {
    plots.set(id, { key, before, plot: plotted(id, title, data, now, old, scale) });
    return;
  }
  if (!known.before) (old?.rows ?? []).forEach((row, n) => known.plot.addSeries(grey(row), n + 1));
  known.before = before;
  known.plot.setData(data, false);
}

const decimal = (_, number) => (number === null || number === undefined ? "-" : number.toFixed(1));
const LINE = { spanGaps: true, points: { show: false }, value: decimal };
const DASHES = [[], [5, 3], [2, 2], [9, 3, 2, 3]];
const HZ = { label: "Hz", value: (_, hz) => (hz === null || hz === undefined ? "-" : hz.toPrecision(4)) };
const grey = (row) => ({ ...LINE, label: `before: ${row.name}`, stroke: GREY, width: 1 });
const coloured = (row, n) => ({ ...LINE, label: row.name, stroke: COLOURS[n % 4], width: 1.6, dash: DASHES[n % 4] });

function plotted(id, title, data, now, old, scale) {
  let place = $(`picture-${id}`);
  if (!place) $("pictures").append((place = make("div", { id: `picture-${id}` })));
  place.replaceChildren();
  const ink = getComputedStyle(document.documentElement).getPropertyValue("--dim");
  const axis = { stroke: ink, grid: { stroke: `${GREY}40`, width: 1 }, ticks: { stroke: `${GREY}40` } };
  const plot = new uPlot(
    {
      title,
      ...sizeIn(place),
      cursor: { sync: { key: "loop" }, drag: { x: true, y: false } },
      scales: { x: { time: false, distr: 3, range: [now.hz[0], now.hz[now.hz.length - 1]] }, y: { range: scale } },
      axes: [axis, { ...axis, size: 46 }],
      series: [HZ, ...(old?.rows ?? []).map(grey), ...now.rows.map(coloured)],
    },
    data,
    place,
  );
  plot.root.setAttribute("role", "img");
  plot.root.setAttribute("aria-label", `${title} over frequency, axis ${state.axis}`);
  return plot;
}

const sizeIn = (place) => ({ width: Math.max(260, place.clientWidth), height: 210 });

function resize() {
  for (const { plot } of plots.values()) plot.setSize(sizeIn(plot.root.parentElement));
}
