// The stones as one mesh, moved by this program: software renderers draw 90,000 triangles of one mesh in a third of the
// time that they take for as many of 270 instances (tests/performance/report_page.py). Who is hidden, who is hit.
const STONE_SHADERS = {
  vertexShader: `
    varying vec3 shade, seen;
    void main() {
      shade = color;
      vec4 place = modelViewMatrix * vec4(position, 1.0);
      seen = place.xyz;
      gl_Position = projectionMatrix * place;
    }`,
  // Flat facets in light that comes over the left shoulder of whoever looks.
  fragmentShader: `
    uniform float opacity;
    varying vec3 shade, seen;
    void main() {
      vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
      float light = 0.55 + 0.3 * normal.y * 0.5 + 0.55 * max(0.0, dot(normal, vec3(-0.48, 0.6, 0.64)));
      gl_FragColor = vec4(shade * light, opacity);
    }`,
};

class Stones {
  constructor(scene, replay) {
    const stones = replay.stones;
    this.replay = replay;
    this.count = stones.ids.length;
    this.shape = stones.shape;
    this.places = unpack(stones.places);
    this.attitudes = unpack(stones.attitudes);
    this.centre = new Float32Array(3 * this.count); // of the present frame [m]
    this.visible = new Uint8Array(this.count);
    this.first = this.firstFrames();
    this.fine = replay.shapes.map((shape) => this.geometry(shape.fine));
    this.coarse = replay.shapes.map((shape) => this.geometry(shape.coarse)); // while things move, where that is slow
    this.material = new THREE.ShaderMaterial({...STONE_SHADERS, vertexColors: THREE.VertexColors,
      uniforms: {opacity: {value: 1}}, extensions: {derivatives: true}});
    this.mesh = new THREE.Mesh(this.emptyGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.outline = new THREE.Mesh(undefined, new THREE.MeshBasicMaterial({color: 0xd55e00, side: THREE.BackSide}));
    this.outline.matrixAutoUpdate = false;
    this.outline.visible = false;
    scene.add(this.mesh, this.outline);
  }

  geometry({vertices, triangles}) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(unpack(vertices), 3));
    geometry.setIndex(new THREE.BufferAttribute(unpack(triangles), 1));
    geometry.computeBoundingSphere();
    return geometry;
  }

  emptyGeometry() {
    const sum = (size) => this.shape.reduce((total, k) => total + size(this.fine[k]), 0);
    const vertices = sum((shape) => shape.attributes.position.count), corners = sum((shape) => shape.index.count);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * vertices), 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(new Uint8Array(3 * vertices), 3, true));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(corners), 1));
    for (const attribute of [...Object.values(geometry.attributes), geometry.index]) attribute.setUsage(THREE.DynamicDrawUsage);
    return geometry;
  }

  // A stone's way is measured from the frame in which it is seen first.
  firstFrames() {
    const first = new Uint16Array(this.count), frames = this.replay.times.length;
    for (let i = 0; i < this.count; ++i) while (first[i] < frames - 1 && !this.isThere(first[i], i)) ++first[i];
    return first;
  }

  isThere(frame, i) {
    const at = 4 * (frame * this.count + i), q = this.attitudes;
    return q[at] !== 0 || q[at + 1] !== 0 || q[at + 2] !== 0 || q[at + 3] !== 0;
  }

  matrix(frame, i, result) {
    const at = frame * this.count + i, q = this.attitudes, [x, y, z] = place(this.replay, this.places, at);
    const turn = new THREE.Quaternion(q[4 * at], q[4 * at + 1], q[4 * at + 2], q[4 * at + 3]).normalize();
    return result.compose(new THREE.Vector3(x, y, z), turn, new THREE.Vector3(1, 1, 1));
  }

  // Where the stone has gone since it was first seen [m].
  way(frame, i) {
    const now = place(this.replay, this.places, frame * this.count + i);
    const then = place(this.replay, this.places, this.first[i] * this.count + i);
    return Math.hypot(...now.map((x, c) => x - then[c]));
  }

  // The scale of ways ends where 98 of 100 stones of the last frame stay below.
  longestWay() {
    const last = this.replay.times.length - 1, ways = [];
    for (let i = 0; i < this.count; ++i) if (this.isThere(last, i)) ways.push(this.way(last, i));
    return Math.max(quantile(ways, 0.98), 1e-4);
  }

  // `isCut(x, y, z)` hides a stone with its centre there; `colour(i)` is red, green, blue.
  update(frame, isCut, colour, isCoarse) {
    const {position, color} = this.mesh.geometry.attributes, index = this.mesh.geometry.index;
    const shapes = isCoarse ? this.coarse : this.fine, matrix = new THREE.Matrix4();
    let vertices = 0, corners = 0;
    for (let i = 0; i < this.count; ++i) {
      const centre = place(this.replay, this.places, frame * this.count + i);
      this.centre.set(centre, 3 * i);
      this.visible[i] = this.isThere(frame, i) && !isCut(...centre) ? 1 : 0;
      if (!this.visible[i]) continue;
      const shape = shapes[this.shape[i]], own = shape.index.array, count = shape.attributes.position.count;
      for (let k = 0; k < own.length; ++k) index.array[corners++] = vertices + own[k];
      this.move(shape.attributes.position.array, this.matrix(frame, i, matrix).elements, position.array, 3 * vertices);
      const shade = colour(i).map((value) => 255 * Math.min(value, 1));
      for (let k = 0; k < count; ++k, ++vertices) color.array.set(shade, 3 * vertices);
    }
    this.mesh.geometry.setDrawRange(0, corners);
    for (const [attribute, used] of [[position, 3 * vertices], [color, 3 * vertices], [index, corners]]) {
      attribute.updateRange = {offset: 0, count: used};
      attribute.needsUpdate = used > 0;
    }
  }

  move(own, m, result, at) {
    for (let k = 0; k < own.length; k += 3, at += 3) {
      const x = own[k], y = own[k + 1], z = own[k + 2];
      result[at] = m[0] * x + m[4] * y + m[8] * z + m[12];
      result[at + 1] = m[1] * x + m[5] * y + m[9] * z + m[13];
      result[at + 2] = m[2] * x + m[6] * y + m[10] * z + m[14];
    }
  }

  // solid, faint or hidden
  look(mode) {
    this.mode = mode;
    this.mesh.visible = mode !== "hidden";
    this.material.transparent = mode === "faint";
    this.material.uniforms.opacity.value = mode === "faint" ? 0.16 : 1;
    this.material.depthWrite = mode !== "faint";
  }

  select(i, frame) {
    this.outline.visible = i >= 0 && this.visible[i] === 1;
    if (!this.outline.visible) return;
    this.outline.geometry = this.fine[this.shape[i]];
    this.matrix(frame, i, this.outline.matrix).scale(new THREE.Vector3(1.07, 1.07, 1.07));
  }

  // The nearest stone that a ray meets, or -1.
  hit(ray, frame) {
    let best = -1, nearest = Infinity;
    const matrix = new THREE.Matrix4(), centre = new THREE.Vector3(), corners = [0, 1, 2].map(() => new THREE.Vector3());
    const point = new THREE.Vector3();
    for (let i = 0; i < this.count; ++i) {
      const geometry = this.fine[this.shape[i]];
      centre.fromArray(this.centre, 3 * i);
      if (!this.visible[i] || ray.distanceToPoint(centre) > geometry.boundingSphere.radius * 1.5) continue;
      const local = ray.clone().applyMatrix4(matrix.getInverse(this.matrix(frame, i, new THREE.Matrix4())));
      const positions = geometry.attributes.position, triangles = geometry.index.array;
      for (let n = 0; n < triangles.length; n += 3) {
        corners.forEach((corner, c) => corner.fromBufferAttribute(positions, triangles[n + c]));
        if (!local.intersectTriangle(...corners, true, point)) continue;
        const distance = point.distanceTo(local.origin);
        if (distance < nearest) [best, nearest] = [i, distance];
      }
    }
    return best;
  }
}
