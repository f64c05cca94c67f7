// Draws both arms, what they hold, what pulls at them, and what rme believes. All lengths in metres, z up.
import {
  BoxGeometry, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, EdgesGeometry, GridHelper,
  Group, HemisphereLight, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  PerspectiveCamera, PlaneGeometry, Quaternion, Scene, SphereGeometry, TorusGeometry, Vector3, WebGLRenderer,
} from 'three';

const kApart = 0.5;       // half of the distance between the arms
const kNewton = 0.012;    // length of an arrow for each newton
const kUp = new Vector3(0, 0, 1);
const kUnknown = 0.15;    // standard deviation of the centre of mass that is too large to be drawn
const kDegrees = Math.PI / 180;
const kTurned = 60 * kDegrees;  // of the arms, so that they are seen from the side

const lambert = (color) => new MeshLambertMaterial({color});
const kWhite = lambert('#e8eaee'), kJoint = lambert('#9aa3b2'), kHand = lambert('#5c6675');
const kIron = lambert('#3d4653'), kClay = lambert('#c9723c'), kBag = lambert('#8a6d3b');
const kPush = new MeshBasicMaterial({color: '#b3261e'}), kFelt = new MeshBasicMaterial({color: '#6a1b9a', wireframe: true});
const kTruth = new LineBasicMaterial({color: '#1f2937'}), kString = new LineBasicMaterial({color: '#5b4a2a'});
const kBelief = new MeshBasicMaterial({color: '#1565c0', wireframe: true, depthTest: false});

function cylinder(radius, length, material, sides = 20) {
  const geometry = new CylinderGeometry(radius, radius, length, sides);
  geometry.rotateX(Math.PI / 2);  // along z
  return new Mesh(geometry, material);
}

const vector = (values, at = 0) => new Vector3(values[at], values[at + 1], values[at + 2]);

/// Lays a mesh along z between two points.
function between(mesh, from, to) {
  const way = to.clone().sub(from);
  mesh.position.copy(from).addScaledVector(way, 0.5);
  mesh.scale.z = Math.max(way.length(), 1e-6);
  mesh.quaternion.setFromUnitVectors(kUp, way.normalize());
}

class Arrow extends Group {
  constructor(material) {
    super();
    this.shaft = cylinder(0.012, 1, material, 8);
    this.head = new Mesh(new ConeGeometry(0.032, 0.07, 10).rotateX(Math.PI / 2), material);
    this.add(this.shaft, this.head);
  }
  show(at, force) {
    const length = kNewton * force.length();
    this.visible = length > 0.012;
    if (!this.visible) return;
    const tip = at.clone().addScaledVector(force, kNewton);
    between(this.shaft, at, tip);
    this.head.position.copy(tip);
    this.head.quaternion.copy(this.shaft.quaternion);
  }
}

class ArmView extends Group {
  /// @param believes  whether what rme believes of it is drawn
  constructor(y, believes) {
    super();
    this.believes = believes;
    this.position.y = y;
    this.rotation.z = kTurned;
    const foot = cylinder(0.1, 0.06, kJoint);
    foot.position.z = 0.03;
    this.add(foot);
    this.limbs = Array.from({length: 8}, (_, i) => cylinder(i < 5 ? 0.055 : 0.045, 1, kWhite));
    this.joints = Array.from({length: 7}, (_, i) => cylinder(i < 5 ? 0.068 : 0.055, i < 5 ? 0.15 : 0.12, kJoint));
    this.flange = new Group();
    const plate = cylinder(0.05, 0.02, kHand);
    const palm = new Mesh(new BoxGeometry(0.05, 0.19, 0.05), kHand);
    palm.position.z = 0.035;
    this.flange.add(plate, palm);
    for (const side of [-1, 1]) {
      const finger = new Mesh(new BoxGeometry(0.02, 0.015, 0.05), kHand);
      finger.position.set(0, side * 0.055, 0.085);
      this.flange.add(finger);
    }
    this.objects = new Group();
    this.flange.add(this.objects);
    this.belief = new Mesh(new SphereGeometry(1, 12, 8), kBelief);
    this.belief.matrixAutoUpdate = false;
    this.flange.add(this.belief);
    this.bag = new Mesh(new SphereGeometry(0.06, 14, 10), kBag);
    this.string = new Line(new BufferGeometry().setFromPoints([new Vector3(), kUp]), kString);
    this.target = new Group();
    this.target.add(new Mesh(new TorusGeometry(0.085, 0.006, 6, 28), new MeshBasicMaterial({color: '#1f2937'})));
    this.stream = cylinder(0.008, 1, new MeshBasicMaterial({color: '#3b82c4'}), 8);
    this.sag = cylinder(0.004, 1, new MeshBasicMaterial({color: '#1f2937'}), 6);
    this.push = new Arrow(kPush);
    this.felt = new Arrow(kFelt);
    this.add(...this.limbs, ...this.joints, this.flange, this.bag, this.string, this.target, this.sag, this.stream,
             this.push, this.felt);
  }

  /// @param get      a field of this arm's numbers
  /// @param push     the force that acts [N]
  /// @param hanging  whether there is a bag
  /// @param pouring  whether a cup is being filled
  update(get, push, hanging, pouring) {
    const links = get('links');
    const pose = (i) => [vector(links, 7 * i), new Quaternion(...links.slice(7 * i + 3, 7 * i + 7))];
    let before = new Vector3();
    for (let i = 0; i < 8; ++i) {
      const [at, turn] = pose(i);
      this.limbs[i].visible = at.distanceTo(before) > 1e-3;
      if (this.limbs[i].visible) between(this.limbs[i], before, at);
      if (i < 7) {
        this.joints[i].position.copy(at);
        this.joints[i].quaternion.copy(turn);
      } else {
        this.flange.position.copy(at);
        this.flange.quaternion.copy(turn);
        this.target.quaternion.copy(turn);
        this.target.position.copy(at).sub(vector(get('error')));
        this.sag.visible = vector(get('error')).length() > 0.004;
        if (this.sag.visible) between(this.sag, this.target.position, at);
      }
      before = at;
    }
    const hand = vector(get('hand')), jug = hand.clone().add(new Vector3(0.07, 0.03, 0.35));
    this.stream.visible = pouring;
    between(this.stream, jug, jug.clone().setZ(hand.z - 0.05));
    this.bag.visible = this.string.visible = hanging;
    if (hanging) {
      this.bag.position.copy(vector(get('bag')));
      this.string.geometry.setFromPoints([hand, this.bag.position]);
    }
    this.push.show(hand, push);
    this.felt.show(hand, this.believes ? vector(get('force')) : new Vector3());

    // The points of mean + 2 L u, |u| = 1, with covariance = L L^T: the ellipsoid of two standard deviations.
    const mean = get('mean'), c = get('com_covariance');
    this.belief.visible = this.believes && get('held')[0] > 0.5 && Math.max(c[0], c[4], c[8]) < kUnknown * kUnknown;
    const a = 2 * Math.sqrt(c[0]), d = 2 * c[1] / Math.sqrt(c[0]), e = 2 * c[2] / Math.sqrt(c[0]);
    const b = Math.sqrt(Math.max(4 * c[4] - d * d, 1e-8)), f = (4 * c[5] - d * e) / b;
    const g = Math.sqrt(Math.max(4 * c[8] - e * e - f * f, 1e-8));
    this.belief.matrix.set(a, 0, 0, mean[1], d, b, 0, mean[2], e, f, g, mean[3], 0, 0, 0, 1);
    this.belief.matrixWorldNeedsUpdate = true;
  }

  /// Draws what is in the hand.
  hold(objects) {
    this.objects.clear();
    for (const {mass, com, kind} of objects) {
      const size = 0.05 * Math.cbrt(Math.max(mass, 0.05));
      const mesh = kind === 'cup' ? cylinder(0.045, 0.03 + 0.06 * mass, kClay) : cylinder(size, 1.6 * size, kIron);
      mesh.position.copy(vector(com));
      mesh.add(new LineSegments(new EdgesGeometry(mesh.geometry, 30), kTruth));
      this.objects.add(mesh);
    }
  }
}

/// Whether there is no graphics card.
function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const name = gl?.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL;
  return name !== undefined && /swiftshader|llvmpipe|software/i.test(gl.getParameter(name));
}

export class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: !drawsInSoftware()});
    this.scene = new Scene();
    this.scene.background = new Color('#f4f6f8');
    this.camera = new PerspectiveCamera(32, 1, 0.1, 10);
    this.camera.up.copy(kUp);
    this.azimuth = 0;
    this.elevation = 12 * kDegrees;
    const sun = new DirectionalLight('#ffffff', 2);
    sun.position.set(2, -1, 3);
    const floor = new GridHelper(3, 15, '#b8c0cc', '#dde2e8');
    floor.rotation.x = Math.PI / 2;
    this.arms = {without: new ArmView(-kApart, false), with: new ArmView(kApart, true)};
    this.wall = new Mesh(new PlaneGeometry(1, 1.1, 5, 5),
                         new MeshBasicMaterial({color: '#37474f', wireframe: true}));
    this.wall.rotation.x = Math.PI / 2;
    this.scene.add(new HemisphereLight('#ffffff', '#b0b6bf', 2), sun, floor, ...Object.values(this.arms));
    this.walls = Object.values(this.arms).map((arm) => {
      const wall = this.wall.clone();
      arm.add(wall);
      return wall;
    });
    this.ratio = Math.min(devicePixelRatio, 2);
    this.interval = this.drawn = 0;  // between two pictures [ms]
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.look();
  }

  /// So far away that both arms are in the picture.
  look() {
    const half = Math.tan(this.camera.fov * kDegrees / 2);
    const distance = Math.max(0.58 / half, 0.98 / (half * this.camera.aspect)) + 0.45;
    const centre = new Vector3(0.15, 0.18, 0.45), c = Math.cos(this.elevation);
    this.camera.position.set(c * Math.cos(this.azimuth), c * Math.sin(this.azimuth), Math.sin(this.elevation))
      .multiplyScalar(distance).add(centre);
    this.camera.lookAt(centre);
    this.camera.updateMatrixWorld();
  }

  turn(dx, dy) {
    this.azimuth = Math.min(Math.max(this.azimuth - 0.006 * dx, -1.2), 1.2);
    this.elevation = Math.min(Math.max(this.elevation + 0.006 * dy, 0), 1.2);
    this.look();
  }

  /// Where a hand is in the picture [pixels].
  handAt(name) {
    const arm = this.arms[name];
    const at = arm.flange.localToWorld(new Vector3(0, 0, 0.1)).project(this.camera);
    return {x: (at.x + 1) / 2 * this.canvas.clientWidth, y: (1 - at.y) / 2 * this.canvas.clientHeight};
  }

  /// A way in the picture [pixels], as one through the hands, in the arms' axes [m].
  inArms(dx, dy) {
    const distance = this.camera.position.distanceTo(this.arms.with.position);
    const scale = 2 * Math.tan(this.camera.fov * kDegrees / 2) * distance / this.canvas.clientHeight;
    const turn = new Matrix4().extractRotation(this.camera.matrixWorld);
    return new Vector3(dx * scale, -dy * scale, 0).applyMatrix4(turn).applyAxisAngle(kUp, -kTurned);
  }

  /// @param get  a field of the numbers, by its name
  draw(get, objects) {
    const key = JSON.stringify(objects);
    for (const [name, arm] of Object.entries(this.arms)) {
      arm.update((field) => get(`${name}.${field}`), vector(get('push')), get('hanging')[0] !== 0, get('pour')[0] > 0);
      if (key !== this.held) arm.hold(objects);
    }
    this.held = key;
    const wall = get('wall_at');
    for (const mesh of this.walls) {
      mesh.visible = get('constrained')[0] !== 0;
      mesh.position.set(0.4, wall[0] + 0.1, 0.5);
    }
    this.renderer.render(this.scene, this.camera);
    this.adapt();
  }

  /// Draws fewer pixels where drawing is slow, as without a graphics card.
  adapt() {
    const now = performance.now(), took = now - this.drawn;
    this.drawn = now;
    if (took < 1000) this.interval += (took - this.interval) / 10;
    if (this.interval < 45 || this.ratio < 0.6) return;
    this.interval = 0;
    this.ratio *= 0.8;
    this.resize();
  }
}
