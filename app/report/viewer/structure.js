// The stones as three.js draws them: faces, edges, marks of opened and slid joints, the chosen stone.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide, LinearSRGBColorSpace,
  LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3,
  WebGLRenderer,
} from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";
import {LineMaterial} from "three/addons/lines/LineMaterial.js";
import {LineSegments2} from "three/addons/lines/LineSegments2.js";
import {LineSegmentsGeometry} from "three/addons/lines/LineSegmentsGeometry.js";

ColorManagement.enabled = false;  // colours are those of the pictures, as they are

const foundationColor = [0.76, 0.76, 0.77];
export const markColors = {opened: 0xdb141a, slid: 0xff8c00, chosen: 0x1565c0};

/// Source: [VanDerWaltSmith2015]; polynomials: [ZuckerColormaps]. @param share 0 to 1
export function viridis(share) {
  const t = Math.min(1, Math.max(0, share));
  const of = (c) => c.reduceRight((sum, value) => sum * t + value, 0);
  return [
    of([0.27772733, 0.10509304, -0.33086183, -4.6342305, 6.22826994, 4.776385, -5.43545586]),
    of([0.00540734, 1.40461353, 0.21484756, -5.79910097, 14.17993337, -13.74514538, 4.64585261]),
    of([0.33409981, 1.38459016, 0.09509516, -19.33244096, 56.6905526, -65.35303263, 26.31243525]),
  ].map((value) => Math.min(1, Math.max(0, value)));
}

function thickLines(color, width) {
  const lines = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({color, linewidth: width, depthTest: true,
    polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4}));
  lines.visible = false;
  lines.frustumCulled = false;
  return lines;
}

export class Structure {
  /// @throws when the browser has no WebGL
  constructor(canvas, recording) {
    this.recording = recording;
    this.renderer = new WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearColor(new Color(0.965, 0.97, 0.976));
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(16, 1, 0.01, 1e4);
    this.camera.up.set(0, 0, 1);
    this.places = new Float32Array(3 * recording.vertexStone.length);
    this.buildStones();
    this.marks = {opened: thickLines(markColors.opened, 3), slid: thickLines(markColors.slid, 3),
      chosen: thickLines(markColors.chosen, 3.5)};
    for (const lines of Object.values(this.marks)) this.scene.add(lines);
    this.buildLights();
    this.controls = new OrbitControls(this.camera, canvas);
    this.home();
  }

  buildStones() {
    const {triangles, edges} = this.recording;
    this.position = new BufferAttribute(this.places, 3);
    this.color = new BufferAttribute(new Float32Array(this.places.length), 3);
    const faces = new BufferGeometry();
    faces.setAttribute("position", this.position);
    faces.setAttribute("color", this.color);
    faces.setIndex(new BufferAttribute(triangles, 1));
    this.stones = new Mesh(faces, new MeshLambertMaterial({vertexColors: true, flatShading: true, side: DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2}));
    const rims = new BufferGeometry();
    rims.setAttribute("position", this.position);
    rims.setIndex(new BufferAttribute(edges, 1));
    this.rims = new LineSegments(rims, new LineBasicMaterial({color: 0x1a1c24, transparent: true, opacity: 0.55}));
    for (const object of [this.stones, this.rims]) {
      object.frustumCulled = false;  // the places change, the bounds are never asked
      this.scene.add(object);
    }
  }

  /// They stand still over the viewer's shoulders.
  buildLights() {
    const main = new DirectionalLight(0xffffff, 1.4), fill = new DirectionalLight(0xffffff, 0.35);
    main.position.set(-0.55, 0.7, 0.75);
    fill.position.set(0.9, 0.1, 0.4);
    this.camera.add(main, fill);
    this.scene.add(new AmbientLight(0xffffff, 1.75), this.camera);
  }

  /// The structure in its first place, without its foundations where there is something else.
  bounds() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const {vertexStone, foundation, centroids, levers} = this.recording;
    const all = foundation.every((held) => held);
    for (let v = 0; v < vertexStone.length; ++v)
      if (all || !foundation[vertexStone[v]])
        for (let k = 0; k < 3; ++k) {
          const place = centroids[3 * vertexStone[v] + k] + levers[3 * v + k];
          low[k] = Math.min(low[k], place);
          high[k] = Math.max(high[k], place);
        }
    return {low: new Vector3(...low), high: new Vector3(...high)};
  }

  /// How far from the middle of a box of this size all of it is seen. @param back unit vector towards the viewer
  distanceToSee(size, back) {
    const right = new Vector3().crossVectors(this.camera.up, back).normalize(), up = new Vector3().crossVectors(back, right);
    const rises = Math.tan(this.camera.fov * Math.PI / 360);  // half a height of the picture at distance 1
    let distance = 0;
    for (const corner of [0, 1, 2, 3, 4, 5, 6, 7]) {
      const place = new Vector3(...size.toArray().map((length, k) => (corner >> k & 1 ? 0.5 : -0.5) * length));
      distance = Math.max(distance, place.dot(back) + Math.max(Math.abs(place.dot(up)) / rises,
                                                               Math.abs(place.dot(right)) / (rises * this.camera.aspect)));
    }
    return distance;
  }

  /// The view of the pictures: the longer horizontal side across, from aside and slightly above.
  home() {
    const {low, high} = this.bounds(), size = high.clone().sub(low), middle = high.clone().add(low).multiplyScalar(0.5);
    const turn = (this.recording.planar ? 0 : 25) * Math.PI / 180, rise = (this.recording.planar ? 0 : 18) * Math.PI / 180;
    const angle = (size.x >= size.y ? -Math.PI / 2 : 0) + turn;
    const back = new Vector3(Math.cos(rise) * Math.cos(angle), Math.cos(rise) * Math.sin(angle), Math.sin(rise));
    const distance = 1.25 * Math.max(this.distanceToSee(size, back), 1e-6);  // room for stones that move
    this.camera.position.copy(back).multiplyScalar(distance).add(middle);
    this.camera.near = 0.02 * distance;
    this.camera.far = 20 * distance;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(middle);
    this.controls.update();
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const lines of Object.values(this.marks)) lines.material.resolution.set(width, height);
  }

  /// @param valueOf (stone) share of the colour scale, or a colour of its own (an array)
  colour(valueOf) {
    const {vertexStone, foundation, names} = this.recording;
    const colors = names.map((_, stone) => {
      if (foundation[stone]) return foundationColor;
      const value = valueOf(stone);
      return Array.isArray(value) ? value : viridis(value);
    });
    for (let v = 0; v < vertexStone.length; ++v) this.color.array.set(colors[vertexStone[v]], 3 * v);
    this.color.needsUpdate = true;
  }

  segments(lines, vertices) {
    lines.visible = vertices.length > 0;
    if (!lines.visible) return;
    const places = new Float32Array(3 * vertices.length);
    vertices.forEach((v, i) => places.set(this.places.subarray(3 * v, 3 * v + 3), 3 * i));
    lines.geometry.dispose();
    lines.geometry = new LineSegmentsGeometry();
    lines.geometry.setPositions(places);
  }

  /// Marks of joints, an opened one in red, one that slid in orange.
  markJoints() {
    const {outlineFirst, outlines, jointCount, threshold} = this.recording;
    const opened = [], slid = [];
    for (let joint = 0; joint < jointCount; ++joint) {
      const open = this.recording.joint("opening", joint) > threshold;
      if (!open && !(this.recording.joint("slip", joint) > threshold)) continue;
      for (let i = outlineFirst[joint]; i < outlineFirst[joint + 1]; ++i) (open ? opened : slid).push(outlines[i]);
    }
    this.segments(this.marks.opened, opened);
    this.segments(this.marks.slid, slid);
  }

  markStone(stone) {
    const {edges, vertexStone} = this.recording, own = [];
    if (stone >= 0)
      for (let i = 0; i < edges.length; i += 2)
        if (vertexStone[edges[i]] === stone) own.push(edges[i], edges[i + 1]);
    this.segments(this.marks.chosen, own);
  }

  place(magnification, chosen) {
    this.recording.placesInto(this.places, magnification);
    this.position.needsUpdate = true;
    this.markJoints();
    this.markStone(chosen);
  }

  /// The stone at a place of the canvas, or -1. @param x, y from -1 to 1, to the right and up
  stoneAt(x, y) {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.camera);
    this.stones.geometry.boundingSphere = null;  // of other places
    const [hit] = ray.intersectObject(this.stones);
    return hit ? this.recording.vertexStone[hit.face.a] : -1;
  }

  draw() { this.renderer.render(this.scene, this.camera); }
}
