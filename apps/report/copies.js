// Many moved copies of few shapes as one mesh, which this program fills anew for each frame: renderers without a graphics
// card are slow with hundreds of instances. Colours and triangles go to the renderer only when they have changed.
class Copies {
  constructor(scene, material, vertices, corners) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * vertices), 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(new Uint8Array(3 * vertices), 3, true));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(corners), 1));
    this.attributes = [geometry.attributes.position, geometry.attributes.color, geometry.index];
    for (const attribute of this.attributes) attribute.setUsage(THREE.DynamicDrawUsage);
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
  }

  begin() {
    this.vertices = this.corners = 0;
    this.isNew = [true, false, false]; // places, colours, triangles
  }

  // A geometry with an index, moved by a matrix of three.js, in a colour of three numbers from 0 to 1.
  add(shape, matrix, colour) {
    const own = shape.attributes.position.array, order = shape.index.array, m = matrix.elements;
    const [position, color, index] = this.attributes.map((attribute) => attribute.array);
    for (let k = 0; k < order.length; ++k, ++this.corners) {
      const corner = this.vertices + order[k];
      if (index[this.corners] !== corner) this.isNew[2] = true;
      index[this.corners] = corner;
    }
    const [red, green, blue] = colour.map((value) => Math.round(255 * Math.min(value, 1)));
    for (let k = 0, at = 3 * this.vertices; k < own.length; k += 3, at += 3) {
      const x = own[k], y = own[k + 1], z = own[k + 2];
      position[at] = m[0] * x + m[4] * y + m[8] * z + m[12];
      position[at + 1] = m[1] * x + m[5] * y + m[9] * z + m[13];
      position[at + 2] = m[2] * x + m[6] * y + m[10] * z + m[14];
      if (color[at] === red && color[at + 1] === green && color[at + 2] === blue) continue;
      color[at] = red;
      color[at + 1] = green;
      color[at + 2] = blue;
      this.isNew[1] = true;
    }
    this.vertices += own.length / 3;
  }

  end() {
    const used = [3 * this.vertices, 3 * this.vertices, this.corners];
    this.mesh.geometry.setDrawRange(0, this.corners);
    this.attributes.forEach((attribute, k) => {
      if (!this.isNew[k] || used[k] === 0) return;
      // What was new in a frame that nobody drew has to go, too; three.js sets the count to -1 when it has gone.
      attribute.updateRange.count = Math.max(attribute.updateRange.count, used[k]);
      attribute.needsUpdate = true;
    });
  }
}
