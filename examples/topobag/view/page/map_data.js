// SPDX-License-Identifier: MIT

// ---- The map, turned so that up is z.
class MapData {
  constructor(json) {
    Object.assign(this, { json, title: json.title, classes: json.classes, image: json.image });
    this.toView = turnBetween(json.up, [0, 0, 1]);
    this.readObjects(json.objects);
    this.readKeyframes(json.keyframes);
    this.matches = json.matches.map((match) => this.readMatch(match));
    this.measure();
  }

  turned(flat) {
    const points = new Float32Array(flat.length);
    for (let i = 0; i < flat.length / 3; ++i) {
      points.set(rotated(this.toView, pointAt(flat, i)), 3 * i);
    }
    return points;
  }

  readObjects(objects) {
    const count = objects.class.length;
    Object.assign(this, {
      objectCount: count, label: objects.class, seen: objects.keyframes,
      first: objects.first, last: objects.last, worldPosition: objects.position,
      position: this.turned(objects.position), size: objects.size,
      half: new Float32Array(3 * count), heading: new Float32Array(2 * count),
    });
    const sight = this.turned(objects.sight);
    for (let i = 0; i < count; ++i) this.shapeBox(i, pointAt(sight, i));
    this.countOf = this.classes.map(() => 0);
    for (const label of this.label) ++this.countOf[label];
  }

  // A detector's box tells how wide an object is and how high in the image: seen from above, that
  // is depth as well. What is seen from all around is as deep as it is wide.
  shapeBox(i, sight) {
    const least = 0.02;
    const [width, tall] = [this.size[2 * i], this.size[2 * i + 1]].map((s) => Math.max(s, least));
    const level = Math.hypot(sight[0], sight[1]);
    const steepness = Math.atan2(Math.abs(sight[2]), Math.max(level, 1e-6));
    const oneSided = Math.min(1, norm(sight));
    const seenDepth = Math.max(tall * Math.sin(steepness), 0.35 * Math.min(width, tall));
    const depth = width + (seenDepth - width) * oneSided;
    const height = Math.max(tall * Math.cos(steepness), 0.2 * tall);
    this.half.set([width / 2, depth / 2, height / 2], 3 * i);
    // The box's x axis lies across the line of sight.
    const heading = level > 1e-6 ? [sight[1] / level, -sight[0] / level] : [1, 0];
    this.heading.set(heading, 2 * i);
  }

  readKeyframes(keyframes) {
    const count = keyframes.name.length;
    Object.assign(this, {
      keyframeCount: count, name: keyframes.name, time: keyframes.time,
      worldCamera: keyframes.position, camera: this.turned(keyframes.position),
      rotation: new Float32Array(4 * count),
      objectsOf: keyframes.objects, edgesOf: keyframes.edges,
    });
    for (let i = 0; i < count; ++i) {
      const q = keyframes.rotation.slice(4 * i, 4 * i + 4);
      this.rotation.set(quaternionProduct(this.toView, q), 4 * i);
    }
  }

  readMatch(match) {
    return {
      ...match,
      camera: rotated(this.toView, match.position),
      turn: quaternionProduct(this.toView, match.rotation),
      missing: match.missing.map((object) => (
        { ...object, place: rotated(this.toView, object.position) })),
    };
  }

  // Where the query of a match is drawn: at its own key frame, or where the match puts it.
  queryPlace(match) {
    return match.query === null ? match.camera : pointAt(this.camera, match.query);
  }

  // Key frames and objects: how far they are from each other, and in how many parts they lie.
  measure() {
    const distances = [];
    this.objectsOf.forEach((objects, i) => {
      for (const object of objects.slice(0, 4)) {
        distances.push(norm(sub(pointAt(this.position, object), pointAt(this.camera, i))));
      }
    });
    this.coneLength = Math.min(Math.max(0.1 * (median(distances) || 1), 0.02), 2);
    const steps = [];
    for (let i = 1; i < this.keyframeCount; ++i) {
      steps.push(norm(sub(pointAt(this.camera, i), pointAt(this.camera, i - 1))));
    }
    const jump = Math.max(40 * (median(steps) || 0), 60 * this.coneLength);
    this.partStarts = [0];
    steps.forEach((step, i) => { if (step > jump) this.partStarts.push(i + 1); });
    this.floor = Infinity;
    for (let i = 0; i < this.objectCount; ++i) {
      this.floor = Math.min(this.floor, this.position[3 * i + 2] - this.half[3 * i + 2]);
    }
    if (!Number.isFinite(this.floor)) this.floor = this.camera[2] - 1;
  }

  partOf(keyframe) {
    let part = this.partStarts.findIndex((start) => start > keyframe);
    if (part < 0) part = this.partStarts.length;
    return part - 1;
  }

  // The key frames of a part, from first to before last.
  keyframesOf(part) {
    return [this.partStarts[part], this.partStarts[part + 1] ?? this.keyframeCount];
  }

  // The ball around a part: of most of what is in it.
  ballOf(part) {
    const [begin, end] = this.keyframesOf(part);
    const points = [];
    for (let i = begin; i < end; ++i) {
      points.push(pointAt(this.camera, i));
      for (const object of this.objectsOf[i]) points.push(pointAt(this.position, object));
    }
    const center = [0, 1, 2].map((axis) => median(points.map((point) => point[axis])));
    const distances = Float64Array.from(points, (point) => norm(sub(point, center))).sort();
    const radius = distances[Math.floor(0.97 * (distances.length - 1))];
    return { center, radius: Math.max(radius, 2 * this.coneLength) };
  }

  // Seconds since the first key frame of its part.
  elapsed(keyframe) {
    return this.time[keyframe] - this.time[this.partStarts[this.partOf(keyframe)]];
  }
}
