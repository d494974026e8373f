// Sends what agents draw: RoboViz's commands in datagrams.
import dgram from 'node:dgram';

const number = (v) => Buffer.from(v.toFixed(4).slice(0, 6).padStart(6, ' '));
const numbers = (...v) => Buffer.concat(v.map(number));
const text = (t) => Buffer.from(`${t}\0`);
const bytes = (...b) => Buffer.from(b);

export const circle = (x, y, r, thickness, rgb, set) => Buffer.concat([bytes(1, 0), numbers(x, y, r, thickness), bytes(...rgb), text(set)]);
export const line = (a, b, thickness, rgb, set) => Buffer.concat([bytes(1, 1), numbers(...a, ...b, thickness), bytes(...rgb), text(set)]);
export const point = (p, size, rgb, set) => Buffer.concat([bytes(1, 2), numbers(...p, size), bytes(...rgb), text(set)]);
export const sphere = (p, r, rgb, set) => Buffer.concat([bytes(1, 3), numbers(...p, r), bytes(...rgb), text(set)]);
export const polygon = (corners, rgba, set) => Buffer.concat([bytes(1, 4, corners.length, ...rgba), numbers(...corners.flat()), text(set)]);
export const annotation = (p, rgb, words, set) => Buffer.concat([bytes(2, 0), numbers(...p), bytes(...rgb), text(words), text(set)]);
export const agentText = (side, unum, rgb, words) => Buffer.concat([bytes(2, 1, unum - 1 + (side === 'right' ? 128 : 0), ...rgb), text(words)]);
export const swap = (set) => Buffer.concat([bytes(0, 0), text(set)]);

export function send(port, datagrams) {
  const socket = dgram.createSocket('udp4');
  return Promise.all(datagrams.map((d) => new Promise((resolve, reject) => socket.send(d, port, '127.0.0.1', (e) => (e ? reject(e) : resolve())))))
    .then(() => socket.close());
}
