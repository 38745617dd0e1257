// The picture with WebGL: all shapes of one kind are one instanced mesh. three.js draws; where
// things are comes from the film.
import {AmbientLight, BufferGeometry, Color, DirectionalLight, DoubleSide, Float32BufferAttribute, HemisphereLight,
  InstancedMesh, Line, LineBasicMaterial, LineLoop, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, MeshStandardMaterial,
  MultiplyOperation, OrthographicCamera, PCFSoftShadowMap, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3,
  WebGLRenderer, type LineBasicMaterialParameters, type Camera as ThreeCamera, type Material} from "three";
import {kFieldOfView, type Camera} from "./camera";
import type {SceneShape} from "./data";
import {add, dot, rotated, scaled, sub, type V3} from "./math";
import type {SceneModel} from "./scene_model";
import {ball, barBetween, capsule, cone, cube, cubeEdges, cylinder, groupKey, helix, meshGeometry, slabGeometry, slabOf, torus,
  type Slab} from "./space_shapes";
import {colourOf, mixed, theme} from "./theme";

const kMany = 1500;  // from here on, and without a graphics card: coarse spheres, no shadows
/** An instance: its frame, its place in the frame with its sizes, its shape. */
interface Instance { frame: number; local: Matrix4; shape: SceneShape }
/** The sheet of a half space, its lines, its outline, and the pose of its frame that they were made for. */
interface Ground {
  sheet: Mesh; lines: LineSegments; outline: LineLoop; shape: SceneShape; made: Matrix4;
  near: LineSegments; seen: string;  // lines of what is looked at, and what that was
}
interface Group { mesh: InstancedMesh; instances: Instance[]; moving: boolean; edges: LineSegments[]; balls: boolean }

export class SpacePicture {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye = new PerspectiveCamera();
  private readonly flat = new OrthographicCamera();
  private readonly groups: Group[] = [];
  private readonly links: {shape: SceneShape; object: Mesh | Line}[] = [];
  private readonly grounds: Ground[] = [];
  private readonly frames: Matrix4[];
  private readonly sun = new DirectionalLight(0xffffff, 1.9);
  private readonly fill = new HemisphereLight(0xffffff, 0xb8c0c8, 1.3);
  private readonly ambient = new AmbientLight(0xffffff, 0.55);
  private used: ThreeCamera = this.eye;
  private marked = -2;
  private hidden: ReadonlySet<number> = new Set();

  /** Throws if there is no WebGL. */
  constructor(first: HTMLCanvasElement, private readonly model: SceneModel, fine: boolean) {
    const {canvas, context, software: plain} = contextOf(first, fine);
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, context, antialias: !plain, preserveDrawingBuffer: true});
    this.renderer.debug.checkShaderErrors = fine;  // else the page waits for each shader
    this.frames = Array.from({length: model.film.poses}, () => new Matrix4());
    const many = plain || model.bodies.length > kMany;
    this.renderer.shadowMap.enabled = !many;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.sun.castShadow = !many;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.normalBias = 0.004 * model.extent.size;
    this.sun.shadow.radius = 4;
    this.scene.add(this.sun, this.sun.target, this.fill, this.ambient);
    this.addBodies(many, model.bodies.length > 200);
    for (const shape of model.grounds) this.addGround(shape, many);
    this.recolour();
  }

  private addBodies(many: boolean, coarse: boolean): void {
    const sorted = new Map<string, Instance[]>(), slabs = new Map<number, Slab[]>();
    const put = (key: string, instance: Instance): void => {
      const list = sorted.get(key);
      if (list) list.push(instance); else sorted.set(key, [instance]);
    };
    this.model.bodies.forEach((shape, index) => {
      if (shape.kind === "link") this.addLink(shape);
      else if (shape.kind === "segment") {
        for (const local of this.bars(shape)) put("cylinder", {frame: shape.frame, local, shape});
      } else put(groupKey(shape, index), {frame: shape.frame, local: localOf(shape), shape});
    });
    for (const [key, instances] of sorted) {
      const {shape} = instances[0];
      let edges: BufferGeometry | null = null, geometry: BufferGeometry;
      if (key === "sphere") geometry = ball(many && coarse);
      else if (key === "box") { geometry = cube(); edges = cubeEdges(); }
      else if (key === "cylinder") geometry = cylinder();
      else if (key === "cone") geometry = cone();
      else if (shape.kind === "torus") geometry = torus(shape.radius ?? 0, shape.tube ?? 0);
      else if (shape.kind === "mesh") ({solid: geometry, edges} = meshGeometry(shape));
      else if (shape.kind === "capsule") geometry = capsule(shape.radius ?? 0, shape.halfLength ?? 0);
      else {
        const under = slabs.get(shape.frame) ?? [], slab = slabOf(shape.points ?? [], under);
        slabs.set(shape.frame, [...under, slab]);
        ({solid: geometry, edges} = slabGeometry(slab));
      }
      this.addGroup(instances, geometry, edges, many);
    }
  }

  private addGroup(instances: Instance[], geometry: BufferGeometry, edges: BufferGeometry | null, many: boolean): void {
    const material: Material = many ? new MeshLambertMaterial({vertexColors: true})
      : new MeshStandardMaterial({vertexColors: true, roughness: 0.62, metalness: 0, side: DoubleSide});
    const mesh = new InstancedMesh(geometry, material, instances.length);
    mesh.frustumCulled = false;
    mesh.castShadow = mesh.receiveShadow = !many;
    const outlines = edges && instances.length <= 300
      ? instances.map(() => new LineSegments(edges, lineMaterial({transparent: true, opacity: 0.55}))) : [];
    for (const o of outlines) { o.matrixAutoUpdate = false; o.frustumCulled = false; }
    this.scene.add(mesh, ...outlines);
    const moving = instances.some(i => this.model.film.moves(i.frame));
    const balls = moving && instances.every(({frame, shape: s}) => frame >= 0 && s.kind === "sphere" &&
      s.position.every(x => x === 0) && s.orientation[0] === 1);
    this.groups.push({mesh, instances, moving, edges: outlines, balls});
    this.place(this.groups[this.groups.length - 1]);
  }

  /** A line as bars of the thickness it has, or a thin one. */
  private bars(shape: SceneShape): Matrix4[] {
    const points = shape.points ?? [], out: Matrix4[] = [], place = poseMatrix(shape.position, shape.orientation);
    // A short line stays a line where the scene is long.
    const length = points.slice(1).reduce((sum, p, i) => sum + Math.hypot(p[0] - points[i][0], p[1] - points[i][1], p[2] - points[i][2]), 0);
    const radius = shape.radius || Math.min(0.0022 * this.model.extent.size, 0.01 * length);
    for (let i = 0; i + 1 < points.length; ++i) {
      out.push(new Matrix4().multiplyMatrices(place, barBetween(points[i], points[i + 1], radius)));
    }
    return out;
  }

  private addLink(shape: SceneShape): void {
    let object: Mesh | Line;
    if (shape.style === "spring") {
      const g = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(helix(), 3));
      object = new Line(g, lineMaterial());
    } else {
      object = new Mesh(cylinder(), new MeshStandardMaterial({vertexColors: true, roughness: 0.6}));
      object.castShadow = true;
    }
    object.matrixAutoUpdate = false;
    object.frustumCulled = false;
    this.scene.add(object);
    this.links.push({shape, object});
  }

  /** The scene has become larger: its grounds are made anew. */
  remeasured(): void {
    for (const {sheet, lines, outline, near} of this.grounds.splice(0)) this.scene.remove(sheet, lines, outline, near);
    for (const shape of this.model.grounds) this.addGround(shape, !this.renderer.shadowMap.enabled);
    this.sun.shadow.normalBias = 0.004 * this.model.extent.size;
    this.recolour();
  }

  private addGround(shape: SceneShape, many: boolean): void {
    const {begin} = this.model.film, {outline, lines} = this.model.sheet(shape, begin, 0.9, 14);
    if (outline.length < 3) return;  // inside of the matter of another half space
    const geometry = (points: V3[]): BufferGeometry =>
      new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
    const offset = {polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4};
    const plane = geometry(outline);
    plane.setIndex(outline.slice(2).flatMap((_, i) => [0, i + 1, i + 2]));
    const {n} = this.model.plane(shape, begin);
    plane.setAttribute("normal", new Float32BufferAttribute(outline.flatMap(() => n), 3));
    // without shadows it needs no light, nor a program of its own beside that of lines
    const sheet = new Mesh(plane, many ? new MeshBasicMaterial(offset) : new MeshLambertMaterial(offset));
    sheet.receiveShadow = !many;
    const ground: Ground = {sheet, lines: new LineSegments(geometry(lines.flat()), lineMaterial()),
      outline: new LineLoop(geometry(outline), lineMaterial()), shape, made: new Matrix4(),
      near: new LineSegments(new BufferGeometry(), lineMaterial()), seen: ""};
    if (shape.frame >= 0) {
      const {r, q} = this.model.film.pose(shape.frame, begin);
      ground.made.copy(poseMatrix(r, q)).invert();
    }
    for (const o of [sheet, ground.lines, ground.outline, ground.near]) { o.matrixAutoUpdate = false; o.frustumCulled = false; }
    this.scene.add(sheet, ground.lines, ground.outline, ground.near);
    this.grounds.push(ground);
  }

  /** Moves the half spaces of moving bodies. The lines of one that is seen from behind would cross the scene: its outline stays. */
  private placeGrounds(camera: Camera, t: number): void {
    for (const ground of this.grounds) {
      const {sheet, lines, outline, shape, made, near} = ground;
      if (shape.frame >= 0) {
        for (const o of [sheet, lines, outline]) {
          o.matrix.multiplyMatrices(this.frames[shape.frame], made);
          o.matrixWorldNeedsUpdate = true;
        }
      }
      const {c, n} = this.model.plane(shape, t), D = camera.hasDepth ? camera.distance : 1e3 * this.model.extent.size;
      lines.visible = dot(n, sub(add(camera.centre, scaled(camera.toward, D)), c)) > 0;
      near.visible = lines.visible && this.stands(shape, t) && this.lookedAt(ground, camera, t);
    }
  }

  /** Is the ground where it was at the start? */
  private stands({frame}: SceneShape, t: number): boolean {
    if (frame < 0) return true;
    const {film} = this.model, a = film.pose(frame, film.begin), b = film.pose(frame, t);
    return a.r.every((x, i) => x === b.r[i]) && a.q.every((x, i) => x === b.q[i]);
  }

  /** Lines around what is looked at, if that is a small part of the ground: else nothing tells that a body travels. */
  private lookedAt(ground: Ground, camera: Camera, t: number): boolean {
    const half = 1.5 * Math.max(camera.width, camera.height) / camera.scale;
    if (half > 0.3 * this.model.extent.size) return false;
    const steps = camera.centre.map(x => Math.round(4 * x / half)), seen = `${half.toPrecision(3)} ${steps.join(" ")}`;
    if (seen === ground.seen) return true;
    ground.seen = seen;
    const {lines} = this.model.sheetAround(ground.shape, t, steps.map(k => k * half / 4) as V3, half, 14);
    ground.near.geometry.dispose();
    ground.near.geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines.flat(2), 3));
    return true;
  }

  /** Colours of the theme; `selected` is brighter. */
  recolour(selected = this.marked): void {
    this.marked = selected;
    this.renderer.setClearColor(theme.paper);
    const ink = theme.dark ? 0.25 : -0.45;
    const accent = new Color(theme.accent), colour = new Color();
    for (const {mesh, instances, edges} of this.groups) {
      instances.forEach(({shape, frame}, i) => {
        const name = colourOf(shape);
        colour.set(name);
        if (frame >= 0 && frame === selected) colour.lerp(accent, 0.75);
        mesh.setColorAt(i, colour);
        if (edges[i]) (edges[i].material as LineBasicMaterial).color.set(mixed(name, ink));
      });
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
    for (const {shape, object} of this.links) (object.material as LineBasicMaterial).color.set(mixed(colourOf(shape), -0.2));
    for (const {sheet, lines, outline, near} of this.grounds) {
      const lit = sheet.material instanceof MeshLambertMaterial;
      (sheet.material as MeshBasicMaterial).color.set(theme.dark ? "#2a323b" : lit ? "#dfe4e9" : "#e7edf4");
      for (const o of [lines, outline, near]) (o.material as LineBasicMaterial).color.set(theme.groundLine);
    }
    this.fill.intensity = theme.dark ? 1.1 : 1.6;
  }

  dispose(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  private place(group: Group): void {
    const m = new Matrix4();
    if (group.balls && !this.hidden.size) placeBalls(group, this.model.film.now);
    else group.instances.forEach(({frame, local}, i) => {
      if (this.hidden.has(frame)) m.makeScale(0, 0, 0);
      else if (frame >= 0) m.multiplyMatrices(this.frames[frame], local); else m.copy(local);
      group.mesh.setMatrixAt(i, m);
      if (group.edges[i]) group.edges[i].matrix.copy(m);
    });
    group.mesh.instanceMatrix.needsUpdate = true;
    group.mesh.boundingSphere = null;
  }

  /** Bodies of these frames are not shown. */
  hide(frames: ReadonlySet<number>): void {
    this.hidden = frames;
    for (const group of this.groups) this.place(group);
    for (const {shape, object} of this.links) object.visible = !frames.has(shape.frame);
  }

  draw(camera: Camera, t: number, selected: number): void {
    if (selected !== this.marked) this.recolour(selected);
    const now = this.model.film.sample(t);
    this.frames.forEach((m, i) => composed(m, now, 7 * i));
    for (const group of this.groups) if (group.moving) this.place(group);
    for (const {shape, object} of this.links) this.placeLink(shape, object, t);
    this.placeGrounds(camera, t);
    this.aim(camera);
    this.renderer.render(this.scene, this.used);
  }

  private placeLink(shape: SceneShape, object: Mesh | Line, t: number): void {
    const [a, b] = [this.model.film.pose(shape.frame, t), this.model.film.pose(shape.frameEnd ?? -1, t)];
    const [p, q] = shape.points ?? [];
    const there = !this.model.absent(shape, t);
    object.visible = there && !this.hidden.has(shape.frame);
    if (!there) return;
    const from = add(a.r, rotated(a.q, p ?? [0, 0, 0])), to = add(b.r, rotated(b.q, q ?? [0, 0, 0]));
    const size = this.model.extent.size;
    if (shape.style === "spring") {
      // the helix runs from 0 to 1: half a bar that begins at the middle of one twice as long
      object.matrix.copy(barBetween(sub(scaled(from, 2), to), to, 0.018 * size));
    } else {
      object.matrix.copy(barBetween(from, to, shape.radius || 0.0025 * size));
    }
  }

  private aim(camera: Camera): void {
    // another run that is compared may lie beside this scene: the view counts, too
    const size = Math.max(this.model.extent.size, 0.5 * camera.height / camera.scale), D = camera.hasDepth ? camera.distance : 3 * size;
    const used = camera.hasDepth ? this.eye : this.flat;
    used.position.set(...add(camera.centre, scaled(camera.toward, D)));
    used.up.set(...camera.up);
    used.lookAt(...camera.centre);
    if (used === this.eye) {
      this.eye.fov = kFieldOfView * 180 / Math.PI;
      this.eye.aspect = camera.width / camera.height;
      this.eye.near = Math.max(0.02 * D, D - 4 * size);
      this.eye.far = D + 6 * size;
      this.eye.updateProjectionMatrix();
    } else {
      const [w, h] = [camera.width / camera.scale / 2, camera.height / camera.scale / 2];
      Object.assign(this.flat, {left: -w, right: w, top: h, bottom: -h, near: 0.01 * size, far: 8 * size});
      this.flat.updateProjectionMatrix();
    }
    this.used = used;
    // the sun stands over the left shoulder of the viewer, never below the ground
    const up: V3 = camera.upAxis === 1 ? [0, 1, 0] : [0, 0, 1];
    const light = camera.isPlanar ? add(scaled(camera.toward, 1.2), add(scaled(camera.up, 0.9), scaled(camera.right, -0.5)))
      : add(scaled(camera.toward, 0.55), add(scaled(up, 1.15), scaled(camera.right, -0.55)));
    const {lo, hi} = this.model.extent;
    const middle = size > 4 / camera.scale * camera.height ? camera.centre : scaled(add(lo, hi), 0.5);
    const reach = Math.min(0.75 * size, 0.9 * camera.width / camera.scale);
    this.sun.target.position.set(...middle);
    this.sun.target.updateMatrixWorld();
    this.sun.position.set(...add(middle, scaled(light, 2 * size)));
    Object.assign(this.sun.shadow.camera, {left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * size, far: 6 * size});
    this.sun.shadow.camera.updateProjectionMatrix();
  }

  /** The frame of the shape that is seen at (x, y); −2: none. */
  pick(camera: Camera, x: number, y: number): number { return this.hit(camera, x, y).frame; }

  /** The same with the point that is seen. */
  hit(camera: Camera, x: number, y: number): {frame: number; point: V3} {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x / camera.width - 1, 1 - 2 * y / camera.height), this.used);
    let nearest = Infinity, frame = -2, point: V3 = [0, 0, 0];
    for (const {mesh, instances} of this.groups) {
      for (const hit of ray.intersectObject(mesh, false)) {
        if (hit.distance < nearest && hit.instanceId !== undefined) {
          nearest = hit.distance;
          frame = instances[hit.instanceId].frame;
          point = hit.point.toArray();
        }
      }
    }
    return {frame, point};
  }
}

/** Balls about the origin of their frame: R A(q) and r straight into the buffer, by far the most common shape of a heap. */
function placeBalls({mesh, instances}: Group, now: Float32Array): void {
  const out = mesh.instanceMatrix.array;
  for (let i = 0; i < instances.length; ++i) {
    const a = 7 * instances[i].frame, R = instances[i].shape.radius ?? 1, o = 16 * i;
    const w = now[a + 3], x = now[a + 4], y = now[a + 5], z = now[a + 6];
    if (w === 0 && x === 0 && y === 0 && z === 0) {  // absent
      out.fill(0, o, o + 16);
      out[o + 15] = 1;
      continue;
    }
    out[o] = R * (1 - 2 * (y * y + z * z)), out[o + 1] = 2 * R * (x * y + w * z), out[o + 2] = 2 * R * (x * z - w * y);
    out[o + 4] = 2 * R * (x * y - w * z), out[o + 5] = R * (1 - 2 * (x * x + z * z)), out[o + 6] = 2 * R * (y * z + w * x);
    out[o + 8] = 2 * R * (x * z + w * y), out[o + 9] = 2 * R * (y * z - w * x), out[o + 10] = R * (1 - 2 * (x * x + y * y));
    out[o + 12] = now[a], out[o + 13] = now[a + 1], out[o + 14] = now[a + 2], out[o + 15] = 1;
  }
}

/** A material of lines that shares the program of `MeshBasicMaterial`. */
function lineMaterial(options: LineBasicMaterialParameters = {}): LineBasicMaterial {
  return Object.assign(new LineBasicMaterial(options), {combine: MultiplyOperation});
}

/**
 * A canvas with a context, and whether the processor draws: then shadows would take seconds, and edges stay rough. Only
 * a graphics card gets a second context, with smooth edges: in software each takes a tenth of a second to begin with.
 */
function contextOf(first: HTMLCanvasElement, fine: boolean):
    {canvas: HTMLCanvasElement; context: WebGL2RenderingContext; software: boolean} {
  const begin = (canvas: HTMLCanvasElement, antialias: boolean): WebGL2RenderingContext => {
    const context = canvas.getContext("webgl2", {preserveDrawingBuffer: true, stencil: false, antialias});
    if (!context) throw new Error("no WebGL");
    return context;
  };
  first.width = innerWidth, first.height = innerHeight;  // about what it will be
  const context = begin(first, fine), info = context.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  if (fine || /swiftshader|llvmpipe|software|basic render/i.test(name)) return {canvas: first, context, software: !fine};
  const canvas = first.cloneNode() as HTMLCanvasElement;
  first.replaceWith(canvas);
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return {canvas, context: begin(canvas, true), software: false};
}

function poseMatrix(r: V3, q: [number, number, number, number]): Matrix4 {
  return new Matrix4().compose(new Vector3(...r), new Quaternion(q[1], q[2], q[3], q[0]), new Vector3(1, 1, 1));
}

/** Place of a shape in its frame with its sizes. */
function localOf(shape: SceneShape): Matrix4 {
  const R = shape.radius ?? 1;
  const [a, b, c]: V3 = shape.kind === "sphere" ? [R, R, R] : shape.kind === "box" || shape.kind === "ellipsoid"
    ? shape.halfExtents ?? [1, 1, 1] : shape.kind === "cylinder" || shape.kind === "cone" ? [R, R, shape.halfLength ?? 1] : shape.kind === "circle" ? [R, R, 0.08 * R] : [1, 1, 1];
  return poseMatrix(shape.position, shape.orientation).scale(new Vector3(a, b, c));
}

const kPlace = new Vector3(), kTurn = new Quaternion(), kOne = new Vector3(1, 1, 1), kNothing = new Vector3(0, 0, 0);
/** The matrix of a pose; of a body that is absent one that draws nothing. */
function composed(m: Matrix4, now: Float32Array, at: number): void {
  kPlace.set(now[at], now[at + 1], now[at + 2]);
  kTurn.set(now[at + 4], now[at + 5], now[at + 6], now[at + 3]);
  m.compose(kPlace, kTurn, kTurn.lengthSq() > 0 ? kOne : kNothing);
}
