// SPDX-License-Identifier: MIT

// ---- The page: one state, and everything that is drawn of it
class MapPage {
  constructor(json) {
    const byId = (id) => document.getElementById(id);
    const map = this.map = new MapData(json);
    const state = this.state = new ViewState(map);
    this.canvas = byId('scene');
    this.camera = new OrbitCamera(this.canvas, () => this.requestDraw());
    this.scene = new Scene(this.canvas, map, this.camera);
    this.pace = new Pace();
    this.way = new WayLines(this.scene, state);
    this.lines = new ChosenLines(this.scene, state);
    this.labels = new Labels(byId('labels'), this.scene, state);
    this.pointing = new Pointing(this.scene, state);
    this.details = new Details(map, state);
    this.matchList = new MatchList(map, state);
    this.timeline = new Timeline(map, state, (part) => this.showPart(part));
    this.tell();
    this.theme = new Theme(byId('theme'), () => this.recolor());
    this.classes = new ClassList(map, state, () => state.change({}));
    Object.assign(state, { onChange: () => this.refill(), onChoice: (...a) => this.show(...a) });
    this.input = new Input(this);
    this.leaveRoom();
    this.showPart(0, true);
    this.refill();
  }

  // What the page is of, in its heading.
  tell() {
    const { map } = this;
    document.getElementById('title').textContent = map.title.replace(/[._]/g, '$&\u200b');
    const counts = [plural(map.objectCount, 'object'),
      `${map.classes.length} ${map.classes.length === 1 ? 'class' : 'classes'}`,
      plural(map.keyframeCount, 'key frame')];
    if (map.json.without_pose) counts.push(`${plural(map.json.without_pose, 'more')} without a pose`);
    document.getElementById('counts').textContent = counts.join(' · ');
    document.getElementById('least').max = Math.min(20, map.seen.reduce((a, b) => Math.max(a, b), 2));
  }

  // The picture's middle is that of what the panels leave free.
  leaveRoom() {
    const beside = innerWidth > 760;
    const [side, time] = ['side', 'time'].map((id) => document.getElementById(id));
    Object.assign(this.camera.covered, {
      left: beside ? side.offsetLeft + side.offsetWidth : 0, bottom: beside ? time.offsetHeight : 0,
    });
    this.requestDraw();
  }

  // What the card covers on the right, where it is open.
  get cardWidth() {
    const card = document.getElementById('details');
    return card.hidden || innerWidth <= 760 ? 0 : card.offsetWidth;
  }

  nameOf({ kind, index }) {
    const { map } = this;
    if (kind === 'object') {
      return `${map.classes[map.label[index]]}, held by ${plural(map.seen[index], 'key frame')}`;
    }
    if (kind === 'keyframe') return `key frame ${map.name[index]}`;
    const match = map.matches[index];
    return `match ${match.name} → ${map.name[match.candidate]}, ${verdictOf(match).text}`;
  }

  seeFromAbove() { this.camera.flyTo({ elevation: 1.56, right: this.cardWidth }); }

  showPart(part, atOnce = false) {
    const { center, radius } = this.map.ballOf(part);
    const goal = { target: center, distance: 2.6 * radius };
    if (atOnce) Object.assign(this.camera, goal);
    else this.camera.flyTo({ ...goal, right: this.cardWidth });
  }

  // After a choice: says it, and moves the picture where that was asked for.
  show(thing, fly) {
    document.getElementById('said').textContent = thing ? this.nameOf(thing) : '';
    if (!thing || !fly) return;
    const { map } = this;
    if (thing.kind === 'object') {
      const size = norm(pointAt(map.half, thing.index));
      this.camera.flyTo({ target: pointAt(map.position, thing.index),
        distance: Math.max(8 * size, 12 * map.coneLength), right: this.cardWidth });
      return;
    }
    const match = map.matches[thing.index];
    const points = thing.kind === 'keyframe' ? [pointAt(map.camera, thing.index),
      ...map.objectsOf[thing.index].map((object) => pointAt(map.position, object))] :
      [match.camera, map.queryPlace(match), pointAt(map.camera, match.candidate),
        ...match.matched.filter(({ object }) => object !== null)
          .map(({ object }) => pointAt(map.position, object))];
    const target = scaled(points.reduce(add), 1 / points.length);
    const radius = Math.max(...points.map((point) => norm(sub(point, target))));
    this.camera.flyTo({ target, distance: 3.2 * Math.max(radius, map.coneLength),
      right: this.cardWidth });
  }

  // Follows the chosen key frame where it has left the middle of the picture.
  follow() {
    if (!this.scene.toClip || this.followed === this.state.keyframe) return;
    this.followed = this.state.keyframe;
    const place = pointAt(this.map.camera, this.state.keyframe);
    const at = this.scene.onScreen(place);
    const { clientWidth, clientHeight } = this.canvas;
    const inside = at && at[0] > 0.1 * clientWidth && at[0] < 0.9 * clientWidth &&
      at[1] > 0.1 * clientHeight && at[1] < 0.9 * clientHeight;
    if (!inside) this.camera.flyTo({ target: place, right: this.cardWidth });
  }

  recolor() {
    this.scene.readColors(this.theme?.dark ?? matchMedia('(prefers-color-scheme: dark)').matches);
    this.refill();
  }

  // Everything that depends on the state, then a picture.
  refill() {
    const { scene, state, map } = this;
    if (!this.classes) return;
    const { classColors, colors } = scene;
    scene.boxes.fill(map, state.shownObjects, (object) => {
      const color = classColors[map.label[object]];
      return state.dimmed(object) ? mix(color, colors.page, 0.82) : color;
    });
    this.way.fill();
    this.lines.fill();
    this.classes.draw(classColors);
    this.details.draw();
    this.matchList.draw();
    this.timeline.draw();
    this.follow();
    this.requestDraw();
  }

  requestDraw(atRest = false) {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((now) => {
      this.asked = false;
      const quick = this.pace.step(now, atRest);
      this.labels.draw(this.scene.draw(quick), quick);
      clearTimeout(this.rest);
      if (quick) this.rest = setTimeout(() => this.requestDraw(true), 300);
    });
  }
}

try {
  new MapPage(JSON.parse(document.getElementById('map-data').textContent));
} catch (error) {
  document.getElementById('failure').hidden = false;
  document.getElementById('failure').textContent = `The map cannot be shown: ${error.message}`;
  throw error;
}
