// The run as the page holds it: stones, joints and frames, and what lies between two frames.

function bytesOf(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes.buffer;
}

const floats = (text) => new Float32Array(bytesOf(text));
const integers = (text) => new Uint32Array(bytesOf(text));
const shares = (text) => new Uint16Array(bytesOf(text));

/// A number of each stone, or each joint, in each frame: 16 bits from the lowest to the largest, the last for none.
class Quantity {
  constructor({lowest, largest, shares: text}, count) {
    Object.assign(this, {count, lowest, step: (largest - lowest) / 65534, steps: shares(text)});
  }
  /// NaN: it has none.
  in(index, frame) {
    const steps = this.steps[frame * this.count + index];
    return steps === 65535 ? NaN : this.lowest + steps * this.step;
  }
  /// Between two frames linear; where one of them has none, that of the nearer.
  at(index, {frame, next, share}) {
    const before = this.in(index, frame), after = this.in(index, next);
    if (Number.isNaN(before + after)) return share < 0.5 ? before : after;
    return before * (1 - share) + after * share;
  }
}

const quantities = (data, count) =>
  Object.fromEntries(Object.entries(data).map(([name, values]) => [name, new Quantity(values, count)]));

/// The largest number, NaN where there is none.
const largestOf = (values) => values.reduce((most, value) => (most >= value ? most : Number.isNaN(value) ? most : value), NaN);

/// Six numbers of a stone in a frame: displacement [m], vector part of the unit quaternion (w >= 0).
const perStone = 6;

/// x + 2 q x (q x x + w x), the quaternion (q, w) applied to x.
function rotate(qx, qy, qz, qw, x, y, z, out) {
  const tx = 2 * (qy * z - qz * y), ty = 2 * (qz * x - qx * z), tz = 2 * (qx * y - qy * x);
  out[0] = x + qw * tx + qy * tz - qz * ty;
  out[1] = y + qw * ty + qz * tx - qx * tz;
  out[2] = z + qw * tz + qx * ty - qy * tx;
}

export class Recording {
  constructor(data) {
    Object.assign(this, {
      names: data.names, groups: data.groups, times: data.times, stages: data.stages, planar: data.planar,
      countedFrom: data.counted_from,
      magnification: data.magnification, threshold: data.threshold_m,
    });
    this.groupOf = integers(data.group_of);
    this.foundation = integers(data.foundation);
    this.centroids = floats(data.centroids);
    this.levers = floats(data.levers);
    this.vertexStone = integers(data.vertex_block);
    this.triangles = integers(data.triangles);
    this.edges = integers(data.edges);
    this.pairs = integers(data.joints);
    this.outlineFirst = integers(data.outline_first);
    this.outlines = integers(data.outlines);
    this.moves = floats(data.moves);
    this.jointCount = this.pairs.length / 2;
    this.ofStones = quantities(data.of_stones, this.names.length);
    this.ofJoints = quantities(data.of_joints, this.jointCount);
    this.jointsOf = this.names.map(() => []);
    for (let j = 0; j < this.jointCount; ++j) {
      this.jointsOf[this.pairs[2 * j]].push(j);
      this.jointsOf[this.pairs[2 * j + 1]].push(j);
    }
    this.now = new Float32Array(this.names.length * perStone);
    this.at = {frame: 0, share: 0};
  }

  get start() { return this.times[0]; }
  get end() { return this.times[this.times.length - 1]; }

  /// Places of the stones at a time [s], linear between two frames.
  seek(time) {
    let frame = 0;
    while (frame + 2 < this.times.length && this.times[frame + 1] <= time) ++frame;
    const next = Math.min(frame + 1, this.times.length - 1);
    const span = this.times[next] - this.times[frame];
    const share = span > 0 ? Math.min(1, Math.max(0, (time - this.times[frame]) / span)) : 0;
    this.at = {frame, next, share};
    const count = this.now.length;
    for (let i = 0; i < count; ++i)
      this.now[i] = this.moves[frame * count + i] * (1 - share) + this.moves[next * count + i] * share;
  }

  /// Of a joint now: opening [m], slip [m], force [N], friction [-]: the share that it uses, or NaN.
  joint(name, joint) { return this.ofJoints[name].at(joint, this.at); }

  /// The largest of the stone's joints, now or in a frame; NaN where none has any.
  largestJoint(name, stone) { return largestOf(this.jointsOf[stone].map((joint) => this.joint(name, joint))); }
  largestJointIn(name, stone, frame) {
    return largestOf(this.jointsOf[stone].map((joint) => this.ofJoints[name].in(joint, frame)));
  }

  /// The stone's displacement in a frame [m], counted as `countedFrom` says.
  displacementIn(stone, frame) {
    const i = frame * this.now.length + stone * perStone;
    return Math.hypot(this.moves[i], this.moves[i + 1], this.moves[i + 2]);
  }
  displacement(stone) {
    const i = stone * perStone;
    return Math.hypot(this.now[i], this.now[i + 1], this.now[i + 2]);
  }

  /// The lowest and the largest of all stones but the foundations, over all frames. @param of (stone, frame)
  range(of) {
    let low = Infinity, high = -Infinity;
    for (let stone = 0; stone < this.names.length; ++stone)
      for (let frame = 0; !this.foundation[stone] && frame < this.times.length; ++frame) {
        const value = of(stone, frame);
        if (value < low) low = value;
        if (value > high) high = value;
      }
    return low <= high ? [low, high] : [0, 0];
  }

  /// Where all vertices are now, displacements magnified. @param places (vertices x 3), overwritten
  placesInto(places, magnification) {
    const turned = [0, 0, 0], m = magnification;
    for (let v = 0; v < this.vertexStone.length; ++v) {
      const stone = this.vertexStone[v], i = stone * perStone, now = this.now;
      const x = this.levers[3 * v], y = this.levers[3 * v + 1], z = this.levers[3 * v + 2];
      const qx = now[i + 3], qy = now[i + 4], qz = now[i + 5];
      rotate(qx, qy, qz, Math.sqrt(Math.max(0, 1 - qx * qx - qy * qy - qz * qz)), x, y, z, turned);
      places[3 * v] = this.centroids[3 * stone] + x + m * (now[i] + turned[0] - x);
      places[3 * v + 1] = this.centroids[3 * stone + 1] + y + m * (now[i + 1] + turned[1] - y);
      places[3 * v + 2] = this.centroids[3 * stone + 2] + z + m * (now[i + 2] + turned[2] - z);
    }
  }
}
