// The interactive view of a report: the run in #view-data, shown in #view. docs/report.md tells of it.
import {coloursOf} from "./colours.js";
import {element, Panel} from "./panel.js";
import {Recording} from "./recording.js";
import {Structure} from "./structure.js";

function choiceOf(label, options) {
  const place = element("label", `${label} `), select = element("select");
  for (const [value, name] of options) select.append(element("option", name, {value}));
  place.append(select);
  return {place, select};
}

class View {
  constructor(root, recording) {
    Object.assign(this, {root, recording, chosen: -1, playing: false, magnification: recording.magnification});
    this.canvas = element("canvas", "", {tabindex: 0, "aria-label": "The structure, to be turned"});
    this.structure = new Structure(this.canvas, recording);
    this.buildControls();
    const stage = element("div", "", {class: "view-stage"}), aside = element("div", "", {class: "view-panel"});
    stage.append(this.canvas, this.legend);
    const body = element("div", "", {class: "view-body"});
    body.append(stage, aside);
    root.replaceChildren(body, this.bar);
    this.panel = new Panel(aside, recording, (stone) => this.choose(stone));
    this.listen(stage);
    this.setColour("displacement");
    this.seek(recording.end);
  }

  buildControls() {
    const {recording} = this;
    this.bar = element("div", "", {class: "view-bar"});
    this.play = element("button", "Play", {type: "button"});
    this.slider = element("input", "", {type: "range", min: recording.start, max: recording.end, step: "any",
      "aria-label": "Time"});
    this.clock = element("output");
    this.colours = coloursOf(recording);
    const colors = choiceOf("Colours", Object.entries(this.colours).map(([name, {words}]) => [name, words]));
    const sizes = choiceOf("Displacements", [...new Set([1, 10, 100, recording.magnification])].sort((a, b) => a - b)
      .map((times) => [times, times === 1 ? "true" : `${times} times`]));
    sizes.select.value = recording.magnification;
    const home = element("button", "First view", {type: "button"});
    this.legend = element("div", "", {class: "view-legend"});
    this.bar.append(this.play, this.slider, this.clock, colors.place, sizes.place, home);
    this.slider.addEventListener("input", () => { this.pause(); this.seek(Number(this.slider.value)); });
    this.play.addEventListener("click", () => (this.playing ? this.pause() : this.start()));
    colors.select.addEventListener("change", () => this.setColour(colors.select.value));
    sizes.select.addEventListener("change", () => { this.magnification = Number(sizes.select.value); this.seek(this.time); });
    home.addEventListener("click", () => this.structure.home());
  }

  listen(stage) {
    let from = null;
    this.canvas.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; });
    this.canvas.addEventListener("pointerup", (event) => {
      if (from && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < 4) this.click(event);
      from = null;
    });
    this.structure.controls.addEventListener("change", () => this.redraw());
    new ResizeObserver(() => {
      this.structure.resize(stage.clientWidth, Math.max(260, Math.round(0.62 * stage.clientWidth)));
      if (!this.placed) this.structure.home();
      this.placed = true;
      this.redraw();
    }).observe(stage);
    // Who scrolls through the page is not caught by the picture: the wheel is its own once it has been touched.
    const {controls} = this.structure;
    controls.enableZoom = false;
    this.canvas.addEventListener("pointerdown", () => { this.canvas.focus(); controls.enableZoom = true; });
    this.canvas.addEventListener("blur", () => { controls.enableZoom = false; });
  }

  click(event) {
    const box = this.canvas.getBoundingClientRect();
    this.choose(this.structure.stoneAt(2 * (event.clientX - box.left) / box.width - 1,
      1 - 2 * (event.clientY - box.top) / box.height));
  }

  choose(stone) {
    this.chosen = stone;
    if (stone < 0) this.panel.clear();
    else this.panel.show(stone);
    this.seek(this.time);
  }

  setColour(name) {
    this.colour = this.colours[name];
    this.range = this.colour.range();
    this.legend.replaceChildren(...this.colour.legend(this.range));
    if (this.time !== undefined) this.seek(this.time);
  }

  seek(time) {
    this.time = time;
    this.recording.seek(time);
    this.structure.colour((stone) => this.colour.of(stone, this.range));
    this.structure.place(this.magnification, this.chosen);
    this.panel.update(time);
    this.slider.value = time;
    this.clock.textContent = `${time.toFixed(3)} s`;
    this.redraw();
  }

  start() {
    this.playing = true;
    this.play.textContent = "Pause";
    const span = this.recording.end - this.recording.start, seconds = Math.max(6, Math.min(span, 60));
    const from = this.time >= this.recording.end ? this.recording.start : this.time, began = performance.now();
    const go = (now) => {
      if (!this.playing) return;
      const time = from + span * Math.max(0, now - began) / 1000 / seconds;
      this.seek(Math.min(time, this.recording.end));
      if (time >= this.recording.end) this.pause();
      else requestAnimationFrame(go);
    };
    requestAnimationFrame(go);
  }

  pause() {
    this.playing = false;
    this.play.textContent = "Play";
  }

  /// Once a frame of the screen at most. What is shown stands in the element's data, for whoever drives the page.
  redraw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.structure.draw();
      Object.assign(this.root.dataset, {state: "ready", time: this.time.toFixed(6),
        stone: this.chosen < 0 ? "" : this.recording.names[this.chosen],
        angle: (this.structure.controls.getAzimuthalAngle() * 180 / Math.PI).toFixed(3)});
    });
  }
}

const root = document.getElementById("view");
try {
  new View(root, new Recording(JSON.parse(document.getElementById("view-data").textContent)));
} catch (error) {
  root.dataset.state = "failed";
  root.replaceChildren(element("p", `The view cannot be shown here (${error.message}). The pictures show the same.`));
}
