// A frame: where everything is at one moment. Its bytes are described in doc/reference/web-protocol.md.
const sides = ['none', 'left', 'right'];
export const poseSize = 7; // x y z, quaternion x y z w

export function decodeFrame(buffer) {
  const view = new DataView(buffer);
  let at = 0;
  const u8 = () => view.getUint8(at++);
  const i16 = () => { const v = view.getInt16(at, true); at += 2; return v; };
  const f32 = () => { const v = view.getFloat32(at, true); at += 4; return v; };
  if (u8() !== 1) return null;
  const count = u8();
  at += 2;
  const time = view.getFloat64(at, true);
  at += 8;
  const ball = new Float32Array(poseSize);
  for (let i = 0; i < 3; ++i) ball[i] = f32();
  for (let i = 3; i < 7; ++i) ball[i] = i16() / 32767;
  const robots = [];
  for (let n = 0; n < count; ++n) {
    const robot = { side: sides[u8()] ?? 'none', unum: u8(), type: u8() };
    const parts = u8();
    const torso = [f32(), f32(), f32()];
    robot.torso = torso;
    robot.poses = new Float32Array(parts * poseSize);
    for (let i = 0; i < parts * poseSize; ++i) {
      const axis = i % poseSize;
      robot.poses[i] = axis < 3 ? torso[axis] + i16() * 1e-4 : i16() / 32767;
    }
    robots.push(robot);
  }
  return { time, ball, robots };
}

// Poses between two frames: out = from + share * (to - from), quaternions on the shorter way.
export function blendPoses(out, from, to, share) {
  for (let i = 0; i < to.length; i += poseSize) {
    for (let k = i; k < i + 3; ++k) out[k] = from[k] + share * (to[k] - from[k]);
    let dot = 0;
    for (let k = i + 3; k < i + 7; ++k) dot += from[k] * to[k];
    const sign = dot < 0 ? -1 : 1;
    let length = 0;
    for (let k = i + 3; k < i + 7; ++k) {
      out[k] = (1 - share) * from[k] * sign + share * to[k];
      length += out[k] * out[k];
    }
    length = Math.sqrt(length) || 1;
    for (let k = i + 3; k < i + 7; ++k) out[k] /= length;
  }
}
