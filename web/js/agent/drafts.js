// What was edited and not saved, kept by the browser through a reload, a crash and the end of the agent.
const prefix = 'plumbline motion ';

export class Drafts {
  constructor(store = globalThis.localStorage) { this.store = store; }
  get(name) {
    try { return JSON.parse(this.store.getItem(prefix + name)); } catch { return null; }
  }
  has(name) { return this.get(name) !== null; }
  put({ name, revision, keyframes }) {
    const when = new Date().toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' });
    try { this.store.setItem(prefix + name, JSON.stringify({ revision, keyframes, when })); } catch { /* the page has it still */ }
  }
  drop(name) { try { this.store.removeItem(prefix + name); } catch { /* there was none */ } }
}
