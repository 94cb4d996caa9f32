// The view in 3-D: what is shown, how it is coloured, and what lies under the pointer.

const grey = [0.72, 0.71, 0.69];
const share = 0.99; // of the values that the colours cover at first
const shades = 256;

/** [shade][red, green, blue], 0 to 1 in the linear space of the renderer */
function viridis() {
  return Array.from({ length: shades }, (_, i) => {
    const colour = new libraries.Color(libraries.interpolateViridis(i / (shades - 1)));
    return [colour.r, colour.g, colour.b];
  });
}

class View {
  constructor(canvas, garment, body) {
    const L = libraries;
    this.canvas = canvas;
    this.renderer = new L.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.scene = new L.Scene();
    this.camera = new L.PerspectiveCamera(30, 1, 1, 1e5);
    this.scene.add(new L.AmbientLight(0xffffff, 1.6));
    this.lamp = new L.DirectionalLight(0xffffff, 1.6);
    this.scene.add(this.lamp);
    this.shades = viridis();
    this.parts = [{ name: "garment", surface: garment }, ...(body ? [{ name: "body", surface: body }] : [])];
    for (const part of this.parts) this.addPart(part);
    this.garment = this.parts[0];
    this.seams = this.addLines(garment.lines(false), 0xf2f0ec);
    this.elements = null;
    this.measure();
    this.controls = new L.OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.look(this.upright ? 30 : 0);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  addPart(part) {
    const L = libraries;
    // The body gives way where fabric lies on it, by about 0.3 % of the distance: coarse elements cut its curves off.
    const behind = part.name === "body";
    part.material = new L.MeshLambertMaterial({ vertexColors: true, side: L.DoubleSide, polygonOffset: true,
      polygonOffsetFactor: behind ? 4 : 1, polygonOffsetUnits: behind ? 500 : 1 });
    part.mesh = new L.Mesh(part.surface.geometry(), part.material);
    part.mesh.userData.part = part;
    this.scene.add(part.mesh);
  }

  addLines(geometry, colour) {
    const lines = new libraries.LineSegments(geometry, new libraries.LineBasicMaterial({ color: colour }));
    this.scene.add(lines);
    return lines;
  }

  /** The box of what is shown, and whether it stands. Flat specimens lie in x and y. */
  measure() {
    const box = (surface) => [0, 1, 2].map((k) => {
      const axis = surface.position.filter((_, i) => i % 3 === k);
      return [axis.reduce((a, b) => Math.min(a, b), Infinity), axis.reduce((a, b) => Math.max(a, b), -Infinity)];
    });
    this.garmentBox = box(this.garment.surface);
    this.box = this.parts.map((part) => box(part.surface)).reduce((a, b) =>
      a.map(([low, high], k) => [Math.min(low, b[k][0]), Math.max(high, b[k][1])]));
    const size = (k) => this.garmentBox[k][1] - this.garmentBox[k][0];
    this.upright = size(2) > 1e-3 * Math.max(size(0), size(1));
  }

  /** From an angle about the vertical, in degrees: 0 from -y. */
  look(angle) {
    const L = libraries, middle = this.garmentBox.map(([low, high]) => (low + high) / 2);
    const size = Math.hypot(...this.garmentBox.map(([low, high]) => high - low));
    const far = 0.62 * size / Math.tan(Math.PI * this.camera.fov / 360) / Math.min(1, this.camera.aspect || 1);
    const turn = angle * Math.PI / 180;
    const from = this.upright ? [Math.sin(turn), -Math.cos(turn), 0.12] : [Math.sin(turn), 0, Math.cos(turn)];
    this.camera.up.set(0, this.upright ? 0 : 1, this.upright ? 1 : 0);
    this.controls.target.set(...middle);
    this.camera.position.copy(new L.Vector3(...from).normalize().multiplyScalar(far).add(this.controls.target));
    this.camera.near = far / 100;
    this.camera.far = far * 20;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.lamp.position.copy(this.camera.position);
      this.renderer.render(this.scene, this.camera);
      this.canvas.dataset.drawn = String(Number(this.canvas.dataset.drawn || 0) + 1);
    });
  }

  /** Range of a field of the garment for the colours: most of its values; from 0 if none is below. */
  rangeOf(name) {
    const owner = this.parts.find((part) => part.surface.fields.has(name));
    const spread = owner && spreadOf(owner.surface.fields.get(name).values, share);
    if (!spread) return [0, 1];
    const low = spread.lowest >= 0 && spread.low < 0.5 * spread.high ? 0 : spread.low;
    if (spread.high - low > 1e-3 * Math.max(Math.abs(low), Math.abs(spread.high))) return [low, spread.high];
    // The same nearly everywhere: rounding is no pattern.
    const [bottom, top] = [Math.min(0, spread.lowest), Math.max(0, spread.largest)];
    return top > bottom ? [bottom, top] : [0, 1];
  }

  colour(name, [low, high]) {
    for (const { surface, mesh } of this.parts) {
      // Beside a garment with colours the body has none: where the garment ends is seen.
      const beside = surface !== this.garment.surface && this.garment.mesh.visible && this.garment.surface.fields.has(name);
      const colours = mesh.geometry.getAttribute("color"), field = beside ? null : surface.fields.get(name);
      const values = field ? surface.cornerValues(field) : null;
      for (let i = 0; i < surface.nodes.length; ++i) {
        const part = values ? (values[i] - low) / (high - low) : NaN;
        const shade = Number.isFinite(part) ? this.shades[Math.round((shades - 1) * Math.min(1, Math.max(0, part)))] : grey;
        colours.array.set(shade, 3 * i);
      }
      colours.needsUpdate = true;
    }
    this.draw();
  }

  /** garment, body, seams, elements: what is shown */
  show(what) {
    for (const part of this.parts) part.mesh.visible = what[part.name];
    this.seams.visible = what.garment && what.seams;
    if (what.elements && !this.elements) {
      this.elements = this.addLines(this.garment.surface.lines(true), 0x4a4744);
      this.elements.material.clippingPlanes = this.seams.material.clippingPlanes;
    }
    if (this.elements) this.elements.visible = what.garment && what.elements;
    this.draw();
  }

  /** Takes away what lies beyond a plane across an axis (0 to 2; null: nothing). */
  cut(axis, place, flipped) {
    const normal = [0, 0, 0];
    if (axis !== null) normal[axis] = flipped ? 1 : -1;
    this.plane = axis === null ? null : new libraries.Plane(new libraries.Vector3(...normal), flipped ? -place : place);
    this.renderer.clippingPlanes = this.plane ? [this.plane] : [];
    this.draw();
  }

  /** What is seen at a place of the canvas (-1 to 1): { part, block, triangle, weights, point }, or null. */
  at(x, y) {
    const L = libraries, ray = new L.Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(new L.Vector2(x, y), this.camera);
    const hits = ray.intersectObjects(this.parts.map((part) => part.mesh).filter((mesh) => mesh.visible), false);
    const seen = hits.filter((hit) => !this.plane || this.plane.distanceToPoint(hit.point) >= 0);
    // Fabric that lies on the body is seen before it.
    const near = seen.filter((hit) => hit.distance < (seen[0]?.distance || 0) * 1.003);
    const hit = near.find((one) => one.object.userData.part.name === "garment") || seen[0];
    if (!hit) return null;
    const part = hit.object.userData.part, triangle = hit.faceIndex;
    return { part, triangle, point: hit.point, weights: this.weights(hit),
      block: part.surface.blockOf(part.surface.elements[triangle]) };
  }

  weights(hit) {
    const places = hit.object.geometry.getAttribute("position"), corners = [0, 1, 2].map((i) =>
      new libraries.Vector3().fromBufferAttribute(places, 3 * hit.faceIndex + i));
    return libraries.Triangle.getBarycoord(hit.point, ...corners, new libraries.Vector3()).toArray();
  }

  turn(about, up) {
    const offset = this.camera.position.clone().sub(this.controls.target), axis = this.camera.up;
    offset.applyAxisAngle(axis, about);
    const side = new libraries.Vector3().crossVectors(axis, offset).normalize();
    const tilted = offset.clone().applyAxisAngle(side, up);
    if (Math.abs(tilted.angleTo(axis) - Math.PI / 2) < 1.5) offset.copy(tilted);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  approach(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.draw();
  }
}
