// A client of the debug protocol (doc/reference/debug-protocol.md) over the page's connection. What is watched goes on
// when the connection comes back.
import { Connection } from '../connection.js';

export class DebugLink {
  constructor({ onState, onLost }) {
    this.open = new Map(); // by tag: {command, line, end, follows}
    this.tags = 0;
    this.onLost = onLost;
    this.online = false;
    this.connection = new Connection({
      onState: (open) => {
        this.online = open;
        if (open) this.resume();
        else this.lost();
        onState(open);
      },
      onText: (text) => text.split('\n').forEach((line) => this.take(line)),
    });
  }

  // One command; resolves with the answer's lines as objects, rejects with the agent's error.
  ask(command) {
    return new Promise((resolve, reject) => {
      const lines = [];
      this.begin({
        command,
        line: (json) => (json.error === undefined ? lines.push(json) : reject(new Error(json.error))),
        end: () => resolve(lines),
        lost: () => reject(new Error('the connection is lost')),
      });
    });
  }

  // Calls take(value) with each value that comes until end() is called; failed(text) at most once.
  watch(name, interval, take, failed = () => {}) {
    const tag = this.begin({
      command: `watch ${name}${interval ? ` every ${interval}` : ''}`, follows: true, name,
      line: (json) => ('value' in json ? take(json.value) : failed(json.error ?? '')),
      end: () => {},
    });
    return {
      end: () => {
        if (!this.open.delete(tag)) return;
        // The server ends all watches of a name at once: the others begin anew.
        this.send(`unwatch ${name}`);
        for (const [other, { command, name: same }] of this.open) if (same === name) this.send(`#${other} ${command}`);
      },
    };
  }

  begin(request) {
    const tag = ++this.tags;
    this.open.set(tag, request);
    if (this.online) this.send(`#${tag} ${request.command}`);
    return tag;
  }

  send(line) { this.connection.sendText(line); }

  take(text) {
    const [, tag, rest] = /^#(\d+) (.*)$/s.exec(text) ?? [];
    if (!tag) {
      if (/left out/.test(text)) this.onLost(text);
      return;
    }
    const request = this.open.get(Number(tag));
    if (!request) return;
    if (rest !== '.') return request.line(JSON.parse(rest));
    if (request.follows) return;
    this.open.delete(Number(tag));
    request.end();
  }

  resume() {
    this.send('format json');
    for (const [tag, { command }] of this.open) this.send(`#${tag} ${command}`);
  }

  lost() {
    for (const [tag, request] of this.open) {
      if (request.follows) continue;
      this.open.delete(tag);
      request.lost();
    }
  }
}
