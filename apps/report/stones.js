// The stones: where they are, which are hidden, which one is hit.
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
    const sum = (size) => this.shape.reduce((total, k) => total + size(this.fine[k]), 0);
    this.copies = new Copies(scene, this.material, sum((shape) => shape.attributes.position.count),
                             sum((shape) => shape.index.count));
    this.mesh = this.copies.mesh;
    this.outline = new THREE.Mesh(undefined, new THREE.MeshBasicMaterial({color: 0xd55e00, side: THREE.BackSide}));
    this.outline.matrixAutoUpdate = false;
    this.outline.visible = false;
    scene.add(this.outline);
  }

  geometry({vertices, triangles}) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(unpack(vertices), 3));
    geometry.setIndex(new THREE.BufferAttribute(unpack(triangles), 1));
    geometry.computeBoundingSphere();
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
    const shapes = isCoarse ? this.coarse : this.fine, matrix = new THREE.Matrix4();
    this.copies.begin();
    for (let i = 0; i < this.count; ++i) {
      const centre = place(this.replay, this.places, frame * this.count + i);
      this.centre.set(centre, 3 * i);
      this.visible[i] = this.isThere(frame, i) && !isCut(...centre) ? 1 : 0;
      if (this.visible[i]) this.copies.add(shapes[this.shape[i]], this.matrix(frame, i, matrix), colour(i));
    }
    this.copies.end();
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
