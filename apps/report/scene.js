// A renderer without a graphics card: pictures take ten times as long.
function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl");
  const info = gl && gl.getExtension("WEBGL_debug_renderer_info");
  return !!info && /swiftshader|llvmpipe|software/i.test(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
}

// Camera, outlines of walls, views. Draws when something has changed, not all the time.
class Scene {
  constructor(canvas, low, high) {
    this.canvas = canvas;
    this.isSlow = isSoftware();
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: !this.isSlow});
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.005, 100);
    this.camera.up.set(0, 0, 1);
    this.middle = new THREE.Vector3(...low).add(new THREE.Vector3(...high)).multiplyScalar(0.5);
    this.half = new THREE.Vector3(...high).sub(this.middle);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.dress();
    isDark.addEventListener("change", () => { this.dress(); this.draw(); });
  }

  dress() {
    this.scene.background = new THREE.Color(style("sky"));
    if (this.walls) this.walls.material.color.set(style("wall"));
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.viewName) this.view(this.viewName);
    this.draw();
  }

  // side: along y; front: from the front wall along x; top; angle.
  view(name) {
    const towards = {side: [0, -1, 0], front: [-1, 0, 0], top: [0, -1e-4, 1], angle: [-0.45, -1, 0.42]}[name];
    const direction = new THREE.Vector3(...towards).normalize();
    this.controls.target.copy(this.middle);
    this.camera.position.copy(this.middle).addScaledVector(direction, 1);
    this.camera.lookAt(this.middle);
    this.camera.updateMatrixWorld();
    this.camera.position.addScaledVector(direction, this.distance(direction) - 1);
    this.controls.update();
    this.viewName = name;
    this.draw();
  }

  // From where all corners of the box are in the picture.
  distance() {
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360) * 0.98, inverse = this.camera.quaternion.clone().inverse();
    let distance = 0;
    for (const x of [-1, 1]) for (const y of [-1, 1]) for (const z of [-1, 1]) {
      const corner = new THREE.Vector3(x, y, z).multiply(this.half).applyQuaternion(inverse);
      const most = Math.max(Math.abs(corner.x) / this.camera.aspect, Math.abs(corner.y));
      distance = Math.max(distance, corner.z + most / tangent);
    }
    return distance;
  }

  // Outlines of walls, cut at the box of the view: `corners` holds x, y, z of four corners.
  setWalls(walls, frame) {
    if (!this.walls) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(24 * walls.length), 3));
      this.walls = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: style("wall")}));
      this.walls.frustumCulled = false;
      this.scene.add(this.walls);
    }
    const points = [];
    const clamp = (value, c) => Math.min(Math.max(value, this.middle.getComponent(c) - this.half.getComponent(c)),
                                         this.middle.getComponent(c) + this.half.getComponent(c));
    for (const wall of walls) {
      const all = wall.corners[frame];
      const corner = (k) => [0, 1, 2].map((c) => clamp(all[3 * (k % 4) + c], c));
      for (let k = 0; k < 4; ++k) points.push(...corner(k), ...corner(k + 1));
    }
    const {position} = this.walls.geometry.attributes;
    position.array.set(points);
    position.needsUpdate = true;
  }

  draw() {
    if (this.drawing) return;
    this.drawing = requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    cancelAnimationFrame(this.drawing);
    this.drawing = 0;
    this.renderer.render(this.scene, this.camera);
  }

  // Waits for the last pixel of the picture.
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  // Where the ray through a place of the canvas [px] goes.
  ray(x, y) {
    const {clientWidth: width, clientHeight: height} = this.canvas, caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    return caster.ray;
  }
}
