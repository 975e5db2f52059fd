// What the colours of the stones show: as in the pictures of docs/pictures.md.
import {element, lengthInWords, speedInWords, strainInWords, stressInWords} from "./panel.js";
import {viridis} from "./structure.js";

/// Ten colours of groups that are told apart without colour vision too, by their lightness.
const groupColors = [[0.27, 0.47, 0.67], [0.93, 0.4, 0.47], [0.13, 0.53, 0.2], [0.8, 0.73, 0.27], [0.4, 0.8, 0.93],
  [0.67, 0.2, 0.47], [0.73, 0.73, 0.73], [0.53, 0.34, 0.2], [0.6, 0.87, 0.6], [0.35, 0.3, 0.6]];

const blankColor = [0.90, 0.89, 0.86];

/// A quantity with one scale for the whole run. @param now (stone), @param then (stone, frame): NaN where it has none
function scaled(recording, words, inWords, now, then, {range, note = ""} = {}) {
  return {
    words,
    range: range || (() => recording.range(then)),
    of(stone, [low, high]) {
      const value = now(stone);
      return Number.isNaN(value) ? blankColor : viridis(high > low ? (value - low) / (high - low) : 0);
    },
    legend: ([low, high]) => [element("span", low === 0 ? "0" : inWords(low)), element("span", "", {class: "view-scale"}),
      element("span", inWords(high)), ...(note ? [element("div", note)] : [])],
  };
}

/// From zero, as all but stresses and strains.
const fromZero = (recording, then) => ({range: () => [0, recording.range(then)[1]]});

function ofGroups(recording) {
  const colorOf = (group) => groupColors[group % groupColors.length];
  return {
    words: "group",
    range: () => [0, 0],
    of: (stone) => colorOf(recording.groupOf[stone]),
    legend() {
      const rows = [];
      recording.groups.forEach((name, i) => {
        if (!recording.groupOf.some((group, stone) => group === i && !recording.foundation[stone])) return;
        const row = element("div"), swatch = element("span", "", {class: "view-swatch"});
        swatch.style.background = `rgb(${colorOf(i).map((c) => Math.round(255 * c)).join(",")})`;
        row.append(swatch, element("span", name));
        rows.push(row);
      });
      return rows.slice(0, 12);
    },
  };
}

/// By name; those of stresses only where stones deform.
export function coloursOf(recording) {
  const ofStones = (name) => [(stone) => recording.ofStones[name].at(stone, recording.at),
    (stone, frame) => recording.ofStones[name].in(stone, frame)];
  const ofJoints = (name) => [(stone) => recording.largestJoint(name, stone),
    (stone, frame) => recording.largestJointIn(name, stone, frame)];
  const zeroed = (words, inWords, [now, then]) => scaled(recording, words, inWords, now, then, fromZero(recording, then));
  const colours = {
    displacement: zeroed("displacement", lengthInWords, [(stone) => recording.displacement(stone),
      (stone, frame) => recording.displacementIn(stone, frame)]),
    opening: zeroed("joint opening", lengthInWords, ofJoints("opening").map((of) => (...which) => of(...which) || 0)),
    slip: zeroed("joint slip", lengthInWords, ofJoints("slip").map((of) => (...which) => of(...which) || 0)),
    friction: scaled(recording, "use of friction", String, ...ofJoints("friction"),
      {range: () => [0, 1], note: "pale: no joint that presses"}),
    speed: zeroed("speed", speedInWords, ofStones("speed")),
  };
  if (recording.ofStones.stress) {
    colours.stress = scaled(recording, "principal stress", stressInWords, ...ofStones("stress"));
    colours.strain = scaled(recording, "principal strain", strainInWords, ...ofStones("strain"));
  }
  return {...colours, group: ofGroups(recording)};
}
