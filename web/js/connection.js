// The stream from the server: JSON messages and binary frames, or bare text; it connects anew when it breaks.
export class Connection {
  constructor({ onMessage, onFrame, onState, onText = (text) => onMessage(JSON.parse(text)) }) {
    this.handlers = { onText, onFrame, onState };
    this.open();
  }

  open() {
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    this.socket = new WebSocket(`${scheme}://${location.host}/${location.search}`, 'plumbline');
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => this.handlers.onState(true);
    this.socket.onclose = () => {
      this.handlers.onState(false);
      setTimeout(() => this.open(), 1000);
    };
    this.socket.onmessage = ({ data }) => {
      if (typeof data === 'string') this.handlers.onText(data);
      else this.handlers.onFrame(data);
    };
  }

  send(command) { this.sendText(JSON.stringify(command)); }

  sendText(text) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(text);
  }
}
