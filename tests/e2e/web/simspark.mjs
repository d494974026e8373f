// The other ends of SimSpark's protocol, as small as tests need them: agents that stand there, and a trainer.
import net from 'node:net';

function frame(text) {
  const bytes = Buffer.from(text, 'latin1'), out = Buffer.alloc(4 + bytes.length);
  out.writeUInt32BE(bytes.length);
  bytes.copy(out, 4);
  return out;
}

/// Connects and calls take(text) for every message.
function connect(port, take) {
  return new Promise((resolve, reject) => {
    const socket = net.connect(port, '127.0.0.1', () => resolve(socket));
    let buffer = Buffer.alloc(0);
    socket.on('error', reject);
    socket.on('data', (bytes) => {
      buffer = Buffer.concat([buffer, bytes]);
      while (buffer.length >= 4 && buffer.length >= 4 + buffer.readUInt32BE()) {
        const length = buffer.readUInt32BE();
        take(buffer.toString('latin1', 4, 4 + length));
        buffer = buffer.subarray(4 + length);
      }
    });
  });
}

/// An agent that beams itself, lowers its arms and stands. It is there once it has beamed: robots that wait for
/// that in the same place cost the physics dearly.
export async function agent(port, { team, unum, type, beam }) {
  let cycle = 0, named = false, there;
  const beamed = new Promise((resolve) => { there = resolve; });
  const socket = await connect(port, () => {
    if (++cycle === 5) there();
    const arms = cycle > 5 && cycle < 80 ? '(lae1 -1)(rae1 -1)' : cycle === 80 ? '(lae1 0)(rae1 0)' : '';
    const init = named ? '' : `(init (unum ${unum})(teamname ${team}))`;
    named = true;
    const move = cycle === 3 ? `(beam ${beam.join(' ')})` : '';
    socket.write(frame(`${init}${move}${arms}(syn)`));
  });
  socket.setNoDelay(true);
  socket.write(frame(`(scene rsg/agent/nao/nao_hetero.rsg ${type})(syn)`));
  await beamed;
  return socket;
}

const places = [[-14.2, 0], [-10, 4], [-10, 1.4], [-10, -1.4], [-10, -4], [-6, 5], [-6, 1.6], [-6, -1.6], [-6, -5], [-2.4, 1.2], [-2.4, -1.2]];

/// Two teams of all types.
export async function twoTeams(port, perTeam = 11) {
  const agents = [];
  for (const team of ['Plumb', 'Line'])
    for (let unum = 1; unum <= perTeam; ++unum)
      agents.push(await agent(port, { team, unum, type: unum % 5, beam: [...places[unum - 1], 0] }));
  return agents;
}

export class Trainer {
  static async open(port) {
    const trainer = new Trainer();
    trainer.messages = 0;
    trainer.socket = await connect(port, (text) => trainer.take(text));
    return trainer;
  }

  take(text) {
    ++this.messages;
    this.last = text;
    if (text.includes('(RSG ')) this.scene = text;
  }

  send(command) { this.socket.write(frame(command)); }

  /// Torso positions of all robots as the server tells them now: asks for the whole scene.
  async torsos() {
    const before = this.messages;
    this.scene = null;
    this.send('(reqfullstate)');
    for (let i = 0; i < 200 && !(this.scene && this.messages > before); ++i) await new Promise((r) => setTimeout(r, 25));
    if (!this.scene) throw new Error('the monitor port tells no scene');
    const robots = [];
    const number = '-?[0-9.e+-]+';
    const pattern = new RegExp(`\\(SLT ((?:${number} ){15}${number})\\)\\(nd TRF \\(SLT [^)]*\\)\\(nd StaticMesh \\(setVisible 1\\) \\(load models/naobody(\\d)\\.obj\\)[^)]*\\)\\(resetMaterials matNum(\\d+) mat(Left|Right)`, 'g');
    for (const [, matrix, type, unum, side] of this.scene.matchAll(pattern)) {
      const m = matrix.split(' ').map(Number);
      robots.push({ type: Number(type), unum: Number(unum), side: side.toLowerCase(), position: m.slice(12, 15) });
    }
    return robots;
  }
}
