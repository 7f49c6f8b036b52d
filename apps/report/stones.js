// The stones: one mesh a shape, drawn once for each stone of it. Who is hidden, who is hit.
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
    this.group = new THREE.Group();
    this.material = new THREE.MeshLambertMaterial({vertexColors: THREE.VertexColors});
    this.meshes = replay.shapes.map((shape, k) => this.mesh(shape, k));
    scene.add(this.group);
    this.outline = new THREE.Mesh(undefined, new THREE.MeshBasicMaterial({color: 0xd55e00, side: THREE.BackSide}));
    this.outline.matrixAutoUpdate = false;
    this.outline.visible = false;
    scene.add(this.outline);
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

  // Facets with edges between them: every corner is a vertex of its own.
  mesh(shape, k) {
    const mine = [];
    for (let i = 0; i < this.count; ++i) if (this.shape[i] === k) mine.push(i);
    const vertices = unpack(shape.vertices), triangles = unpack(shape.triangles);
    const corners = new Float32Array(3 * triangles.length);
    triangles.forEach((v, n) => corners.set(vertices.subarray(3 * v, 3 * v + 3), 3 * n));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    geometry.computeVertexNormals();
    geometry.computeBoundingSphere();
    geometry.setAttribute("color", new THREE.InstancedBufferAttribute(new Float32Array(3 * mine.length).fill(1), 3));
    const mesh = new THREE.InstancedMesh(geometry, this.material, Math.max(1, mine.length));
    mesh.frustumCulled = false;
    mesh.visible = mine.length > 0;
    mesh.userData.stones = mine;
    this.group.add(mesh);
    return mesh;
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
  update(frame, isCut, colour) {
    const matrix = new THREE.Matrix4(), nothing = new THREE.Matrix4().makeScale(0, 0, 0);
    for (const mesh of this.meshes) {
      const colours = mesh.geometry.attributes.color;
      mesh.userData.stones.forEach((i, n) => {
        const centre = place(this.replay, this.places, frame * this.count + i);
        this.centre.set(centre, 3 * i);
        this.visible[i] = this.isThere(frame, i) && !isCut(...centre) ? 1 : 0;
        mesh.setMatrixAt(n, this.visible[i] ? this.matrix(frame, i, matrix) : nothing);
        colours.array.set(colour(i), 3 * n);
      });
      mesh.instanceMatrix.needsUpdate = true;
      colours.needsUpdate = true;
    }
  }

  // solid, faint or hidden
  look(mode) {
    this.mode = mode;
    this.group.visible = mode !== "hidden";
    this.material.transparent = mode === "faint";
    this.material.opacity = mode === "faint" ? 0.13 : 1;
    this.material.depthWrite = mode !== "faint";
    this.material.needsUpdate = true;
  }

  select(i, frame) {
    this.outline.visible = i >= 0 && this.visible[i] === 1;
    if (!this.outline.visible) return;
    this.outline.geometry = this.meshes[this.shape[i]].geometry;
    this.matrix(frame, i, this.outline.matrix).scale(new THREE.Vector3(1.07, 1.07, 1.07));
  }

  // The nearest stone that a ray meets, or -1.
  hit(ray, frame) {
    let best = -1, nearest = Infinity;
    const matrix = new THREE.Matrix4(), centre = new THREE.Vector3(), corners = [0, 1, 2].map(() => new THREE.Vector3());
    const point = new THREE.Vector3();
    for (let i = 0; i < this.count; ++i) {
      const {geometry} = this.meshes[this.shape[i]];
      centre.fromArray(this.centre, 3 * i);
      if (!this.visible[i] || ray.distanceToPoint(centre) > geometry.boundingSphere.radius * 1.5) continue;
      const local = ray.clone().applyMatrix4(matrix.getInverse(this.matrix(frame, i, new THREE.Matrix4())));
      const positions = geometry.attributes.position;
      for (let n = 0; n < positions.count; n += 3) {
        corners.forEach((corner, c) => corner.fromBufferAttribute(positions, n + c));
        if (!local.intersectTriangle(...corners, true, point)) continue;
        const distance = point.distanceTo(local.origin);
        if (distance < nearest) [best, nearest] = [i, distance];
      }
    }
    return best;
  }
}
