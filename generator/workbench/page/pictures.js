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
  if (axis !== state.axis) return;
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
  const image = picture(data.nyquist, `Nyquist curve of the loop of axis ${axis}`);
  const at = $("nyquist");
  if (at) at.replaceChildren(image);
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

function draw(id, title, now, old, scale) {
  const data = joined(now, old);
  const key = [state.axis, ...(old ? old.rows : []), ...now.rows].map((row) => row.name ?? row).join("|");
  const known = plots.get(id);
  if (known?.key === key) {
    known.plot.setData(data, false);
    return;
  }
  let place = $(`picture-${id}`);
  if (!place) $("pictures").append((place = make("div", { id: `picture-${id}` })));
  place.replaceChildren();
  const grey = (row) => ({ label: `before: ${row.name}`, stroke: GREY, width: 1, spanGaps: true, points: { show: false } });
  const line = (row, n) => ({ label: row.name, stroke: COLOURS[n % 4], width: 1.6, dash: [[], [5, 3], [2, 2], [9, 3, 2, 3]][n % 4], spanGaps: true, points: { show: false } });
  const value = (_, number) => (number === null || number === undefined ? "-" : number.toFixed(1));
  const ink = getComputedStyle(document.documentElement).getPropertyValue("--dim");
  const axis = { stroke: ink, grid: { stroke: `${GREY}40`, width: 1 }, ticks: { stroke: `${GREY}40` } };
  const series = [{ label: "Hz", value: (_, hz) => (hz === null || hz === undefined ? "-" : hz.toPrecision(4)) }, ...(old?.rows ?? []).map(grey), ...now.rows.map(line)];
  const plot = new uPlot({
    title, width: Math.max(260, place.clientWidth), height: 210,
    cursor: { sync: { key: "loop" }, drag: { x: true, y: false } },
    scales: { x: { time: false, distr: 3, range: [now.hz[0], now.hz[now.hz.length - 1]] }, y: { range: scale } },
    axes: [axis, { ...axis, size: 46 }],
    series: series.map((of, n) => (n ? { ...of, value } : of)),
  }, data, place);
  plot.root.setAttribute("role", "img");
  plot.root.setAttribute("aria-label", `${title} over frequency, axis ${state.axis}`);
  plots.set(id, { key, plot });
}

function resize() {
  for (const { plot } of plots.values()) plot.setSize({ width: Math.max(260, plot.root.parentElement.clientWidth), height: 210 });
}
