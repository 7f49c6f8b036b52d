// The contact network: rods from centre to centre, or to the point at a wall or rib, as thick as their force.
class Contacts {
  constructor(scene, replay) {
    const {contacts} = replay;
    this.replay = replay;
    this.starts = contacts.starts;
    this.ends = unpack(contacts.ends);
    this.force = unpack(contacts.force);
    this.of = unpack(contacts.of);
    this.stones = unpack(contacts.stones);
    // One outlier must not thin all the others.
    this.reference = quantile(this.force, 0.995) || 1;
    const most = Math.max(1, ...this.starts.slice(1).map((start, k) => start - this.starts[k]));
    const geometry = new THREE.CylinderBufferGeometry(1, 1, 1, 6, 1, true).rotateX(Math.PI / 2);
    geometry.setAttribute("color", new THREE.InstancedBufferAttribute(new Float32Array(3 * most), 3));
    const material = new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors});
    this.mesh = new THREE.InstancedMesh(geometry, material, most);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    scene.add(this.mesh);
  }

  // Contacts below a hundredth of the reference are too thin to be seen.
  update(frame, isCut) {
    if (!this.mesh.visible) return;
    const thickest = 0.0022, colours = this.mesh.geometry.attributes.color; // [m]
    const matrix = new THREE.Matrix4(), turn = new THREE.Quaternion(), axis = new THREE.Vector3();
    const ahead = new THREE.Vector3(0, 0, 1);
    let n = 0;
    for (let k = this.starts[frame]; k < this.starts[frame + 1]; ++k) {
      const share = this.force[k] / this.reference;
      if (share < 0.01) continue;
      const a = new THREE.Vector3(...place(this.replay, this.ends, 2 * k));
      const b = new THREE.Vector3(...place(this.replay, this.ends, 2 * k + 1));
      axis.subVectors(b, a);
      const length = axis.length(), middle = a.add(b).multiplyScalar(0.5);
      if (length === 0 || isCut(middle.x, middle.y, middle.z)) continue;
      const radius = thickest * Math.min(Math.max(share, 0.06), 1.5);
      turn.setFromUnitVectors(ahead, axis.divideScalar(length));
      this.mesh.setMatrixAt(n, matrix.compose(middle, turn, new THREE.Vector3(radius, radius, length)));
      colours.array.set(colourAt("force", share), 3 * n);
      ++n;
    }
    this.mesh.count = n;
    this.mesh.instanceMatrix.needsUpdate = true;
    colours.needsUpdate = true;
  }

  // With how many stones, walls and ribs the stone is in touch.
  count(frame, stone) {
    const counts = [0, 0, 0];
    for (let k = this.starts[frame]; k < this.starts[frame + 1]; ++k)
      if (this.stones[2 * k] === stone || this.stones[2 * k + 1] === stone) ++counts[this.of[k]];
    return counts;
  }
}
