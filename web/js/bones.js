// What joins a robot's bodies: from where a joint leaves a body to the joint, a round bone. The server's bodies are
// boxes with space between them at elbows, hips and knees.

const within = (x, half) => Math.max(-half, Math.min(half, x));

// The point inside a box nearest to a place, a little under its surface; the middle of any other shape.
function inside({ shape, size }, place) {
  return shape === 'box' ? place.map((x, i) => within(x, size[i] * 0.42)) : [0, 0, 0];
}

// Bones of a part in its own axes: middle, direction, length between the ends' middles, radius.
export function bonesOf(part) {
  if (part.shape !== 'box' || !part.joints) return [];
  const radius = Number(Math.min(0.022, Math.min(part.size[0], part.size[1]) * 0.3).toFixed(3));
  return part.joints.map((joint) => {
    const from = inside(part, joint);
    const way = joint.map((x, i) => x - from[i]);
    const length = Math.hypot(...way);
    return {
      middle: joint.map((x, i) => (x + from[i]) / 2),
      direction: length > 1e-3 ? way.map((x) => x / length) : [0, 0, 1],
      length, radius,
    };
  });
}
