// What is known of the chosen stone: its history as a diagram, and its joints. Texts of other people stay texts.

const svgNames = "http://www.w3.org/2000/svg";

export function element(name, text = "", attributes = {}) {
  const made = document.createElement(name);
  made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function drawn(name, attributes, text = "") {
  const made = document.createElementNS(svgNames, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

/// "12.3 mm", "1.23 m", "45 µm".
export function lengthInWords(metres) {
  if (metres >= 1) return `${figure(metres)} m`;
  return metres >= 1e-4 || metres === 0 ? `${figure(1e3 * metres)} mm` : `${figure(1e6 * metres)} µm`;
}

const figure = (value) => Number(value.toPrecision(3)).toString();
const inUnits = (value, units) => {
  const [size, name] = units.find(([least]) => Math.abs(value) >= least) || units.at(-1);
  return value === 0 ? `0 ${name}` : `${figure(value / size)} ${name}`;
};

export const speedInWords = (speed) => inUnits(speed, [[1, "m/s"], [1e-3, "mm/s"], [1e-6, "µm/s"]]);
export const stressInWords = (stress) => inUnits(stress, [[1e6, "MPa"], [1e3, "kPa"], [1, "Pa"]]);
export const strainInWords = (strain) => inUnits(strain, [[1e-3, "mm/m"], [1e-6, "µm/m"]]);

/// "83 %", or a dash where the joint has none.
const shareInWords = (share) => (Number.isNaN(share) ? "–" : `${Math.round(100 * share)} %`);

const width = 320, height = 130, left = 8, right = 8, top = 18, bottom = 20;

/// Curves over time with one scale. @param curves {name, color, values} @returns the diagram, and a mark to be moved
function diagram(times, curves) {
  const largest = Math.max(...curves.map((curve) => Math.max(...curve.values)), 1e-12);
  const across = (time) => left + (width - left - right) * (time - times[0]) / Math.max(times.at(-1) - times[0], 1e-12);
  const up = (value) => height - bottom - (height - top - bottom) * value / largest;
  const svg = drawn("svg", {viewBox: `0 0 ${width} ${height}`, role: "img", class: "view-history",
    "aria-label": "History of the chosen stone"});
  svg.append(drawn("line", {x1: left, x2: width - right, y1: up(0), y2: up(0), stroke: "#9aa0ab"}));
  for (const curve of curves)
    svg.append(drawn("polyline", {fill: "none", stroke: curve.color, "stroke-width": 1.8,
      points: times.map((time, i) => `${across(time).toFixed(1)},${up(curve.values[i]).toFixed(1)}`).join(" ")}));
  let x = left;
  for (const curve of curves) {
    svg.append(drawn("text", {x, y: 12, "font-size": 10.5, fill: curve.color}, curve.name));
    x += 6.4 * curve.name.length + 8;
  }
  svg.append(drawn("text", {x: width - right, y: 12, "font-size": 10.5, "text-anchor": "end", fill: "#616672"},
    `up to ${lengthInWords(largest)}`));
  svg.append(drawn("text", {x: left, y: height - 6, "font-size": 10.5, fill: "#616672"}, `${times[0].toPrecision(3)} s`));
  svg.append(drawn("text", {x: width - right, y: height - 6, "font-size": 10.5, "text-anchor": "end", fill: "#616672"},
    `${times.at(-1).toPrecision(3)} s`));
  const mark = drawn("line", {y1: top, y2: height - bottom, stroke: "#c4161c"});
  svg.append(mark);
  return {svg, move(time) { mark.setAttribute("x1", across(time)); mark.setAttribute("x2", across(time)); }};
}

export class Panel {
  /// @param place the element that is filled; @param choose (stone) called when a neighbour is asked for
  constructor(place, recording, choose) {
    Object.assign(this, {place, recording, choose});
    this.clear();
  }

  clear() {
    this.stone = -1;
    this.place.replaceChildren(element("p", "Click a stone for its history and its joints. Drag to turn, roll to come nearer, "
      + "drag with the right button to shift.", {class: "more"}));
  }

  show(stone) {
    const {recording} = this;
    this.stone = stone;
    const frames = recording.times.map((_, frame) => frame);
    const joint = (name, frame) => recording.largestJointIn(name, stone, frame) || 0;
    this.diagram = diagram(recording.times, [
      {name: "displacement", color: "#31688e", values: frames.map((frame) => recording.displacementIn(stone, frame))},
      {name: "joint opening", color: "#c4161c", values: frames.map((frame) => joint("opening", frame))},
      {name: "joint slip", color: "#d97700", values: frames.map((frame) => joint("slip", frame))},
    ]);
    this.line = element("p", "", {class: "more"});
    const table = element("table");
    const head = element("tr");
    for (const name of ["joint with", "opening", "slip", "force", "friction"]) head.append(element("th", name));
    table.append(head);
    this.rows = recording.jointsOf[stone].map((j) => {
      const other = recording.pairs[2 * j] === stone ? recording.pairs[2 * j + 1] : recording.pairs[2 * j];
      const row = element("tr"), cell = element("td"), name = element("button", recording.names[other], {type: "button"});
      name.addEventListener("click", () => this.choose(other));
      cell.append(name);
      const figures = [element("td"), element("td"), element("td"), element("td")];
      row.append(cell, ...figures);
      table.append(row);
      return {joint: j, figures};
    });
    const group = recording.groups[recording.groupOf[stone]] || "";
    this.place.replaceChildren(element("h3", recording.names[stone]),
      element("p", group ? `Group ${group}${recording.foundation[stone] ? ", follows the ground" : ""}` : "", {class: "more"}),
      this.diagram.svg, this.line, table);
  }

  /// Figures of the moment.
  update(time) {
    if (this.stone < 0) return;
    this.diagram.move(time);
    this.line.textContent = `At ${time.toFixed(3)} s moved by ${lengthInWords(this.recording.displacement(this.stone))} `
      + `${this.recording.countedFrom}.`;
    for (const {joint, figures} of this.rows) {
      figures[0].textContent = lengthInWords(this.recording.joint("opening", joint));
      figures[1].textContent = lengthInWords(this.recording.joint("slip", joint));
      figures[2].textContent = `${Number((this.recording.joint("force", joint) / 1e3).toPrecision(3))} kN`;
      figures[3].textContent = shareInWords(this.recording.joint("friction", joint));
    }
  }
}
