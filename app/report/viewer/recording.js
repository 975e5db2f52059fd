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
    this.quantities = {};
    for (const name of ["opening", "slip", "force"])
      this.quantities[name] = {values: shares(data[name]), scale: data.largest[name] / 65535};
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

  /// Of a joint now: opening [m], slip [m] or force [N].
  joint(name, joint) {
    const {frame, next, share} = this.at;
    return this.jointIn(name, joint, frame) * (1 - share) + this.jointIn(name, joint, next) * share;
  }
  jointIn(name, joint, frame) {
    const {values, scale} = this.quantities[name];
    return values[frame * this.jointCount + joint] * scale;
  }
  largestJoint(name, stone, of) {
    let largest = 0;
    for (const joint of this.jointsOf[stone]) largest = Math.max(largest, of(joint));
    return largest;
  }

  /// The stone's displacement relative to the ground in a frame [m].
  displacementIn(stone, frame) {
    const i = frame * this.now.length + stone * perStone;
    return Math.hypot(this.moves[i], this.moves[i + 1], this.moves[i + 2]);
  }
  displacement(stone) {
    const i = stone * perStone;
    return Math.hypot(this.now[i], this.now[i + 1], this.now[i + 2]);
  }

  /// Of all stones but the foundations, over all frames.
  largest(of) {
    let largest = 0;
    for (let stone = 0; stone < this.names.length; ++stone)
      if (!this.foundation[stone])
        for (let frame = 0; frame < this.times.length; ++frame) largest = Math.max(largest, of(stone, frame));
    return largest;
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
