// Score board, trainer's buttons and the bar of a recorded match.
const $ = (id) => document.getElementById(id);

function clockText(seconds, digits = 1) {
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(digits).padStart(digits + 3, '0')}`;
}

// "KickOff_Left" and "corner_kick_left" read alike: "kick off left".
function modeText(mode) {
  return mode.replace(/([a-z])([A-Z])/g, '$1 $2').replace(/_/g, ' ').toLowerCase() || '-';
}

export class Hud {
  constructor({ send, onCamera, onLabels, onDrawings, onSet }) {
    Object.assign(this, { send, onCamera, onSet });
    this.game = { live: true, clock: null };
    this.replay = null;
    for (const button of document.querySelectorAll('[data-camera]')) button.onclick = () => this.camera(button.dataset.camera);
    for (const button of document.querySelectorAll('[data-do]')) button.onclick = () => this.trainer(button.dataset.do);
    $('rate').onchange = () => send({ do: 'speed', speed: Number($('rate').value) });
    $('showLabels').onchange = () => onLabels($('showLabels').checked);
    $('showDrawings').onchange = () => onDrawings($('showDrawings').checked);
    $('replayPlay').onclick = () => this.togglePlay();
    $('replayTime').oninput = () => send({ do: 'seek', time: Number($('replayTime').value) });
    $('replayRate').onchange = () => send({ do: 'rate', rate: Number($('replayRate').value) });
    window.addEventListener('keydown', (e) => this.key(e));
    this.pace = [];
  }

  key(event) {
    if (/INPUT|SELECT/.test(document.activeElement?.tagName) && event.key !== 'Escape') return;
    const cameras = ['free', 'side', 'ball', 'robot', 'top'];
    if (cameras[Number(event.key) - 1]) this.camera(cameras[Number(event.key) - 1]);
    if (event.key === ' ') {
      event.preventDefault();
      if (this.replay) this.togglePlay();
      else this.trainer('pause');
    }
    if (event.key === '.') this.trainer('step');
  }

  camera(mode) {
    for (const button of document.querySelectorAll('[data-camera]')) button.classList.toggle('chosen', button.dataset.camera === mode);
    this.onCamera(mode);
  }

  trainer(what) {
    if (!this.game.live) return;
    const { clock } = this.game;
    if ((what === 'pause' || what === 'step') && !clock) return;
    const commands = {
      kickOffLeft: { do: 'kickOff', side: 'left' },
      kickOffRight: { do: 'kickOff', side: 'right' },
      playOn: { do: 'playMode', mode: 'PlayOn' },
      dropBall: { do: 'dropBall' },
      reset: { do: 'reset' },
      pause: { do: clock?.paused ? 'resume' : 'pause' },
      step: { do: 'step', cycles: 1 },
    };
    if (what === 'step' && !clock.paused) this.send({ do: 'pause' });
    this.send(commands[what]);
  }

  togglePlay() { this.send({ do: this.replay?.playing ? 'stop' : 'play' }); }

  takeGame(game) {
    this.game = game;
    $('leftName').textContent = game.left.name || 'Left';
    $('rightName').textContent = game.right.name || 'Right';
    $('leftScore').textContent = game.left.score;
    $('rightScore').textContent = game.right.score;
    $('mode').textContent = modeText(game.mode) + (game.half > 1 ? ` · half ${game.half}` : '');
    $('source').textContent = game.source;
    $('recording').hidden = !game.recording;
    $('recording').title = game.recording;
    $('problem').textContent = game.problem;
    $('trainer').hidden = !game.live;
    for (const element of document.querySelectorAll('[data-clock]')) {
      element.disabled = !game.clock;
      if (!game.clock) element.title = 'This server cannot do that';
    }
    document.querySelector('[data-do=pause]').textContent = game.clock?.paused ? 'Resume' : 'Pause';
    const rate = $('rate');
    if (game.clock && document.activeElement !== rate) {
      const value = String(game.clock.speed);
      if (![...rate.options].some((o) => o.value === value)) rate.add(new Option(value, value));
      rate.value = value;
    }
  }

  takeReplay(replay) {
    this.replay = replay;
    $('replay').hidden = false;
    $('replayPlay').textContent = replay.playing ? '❚❚' : '▶';
    const slider = $('replayTime');
    slider.max = replay.duration;
    if (!slider.matches(':active')) slider.value = replay.time;
    $('replayClock').textContent = `${clockText(replay.time)} / ${clockText(replay.duration)}`;
    if (replay.problem) $('problem').textContent = replay.problem;
  }

  takeTime(time, now) {
    $('clock').textContent = clockText(Math.max(0, time));
    this.pace.push([now, time]);
    while (this.pace.length > 2 && now - this.pace[0][0] > 2000) this.pace.shift();
    if (time < this.pace[0][1]) this.pace = [[now, time]];
  }

  // Game time per time of the clock on the wall; nothing while the game's clock stands.
  realTimeFactor(now) {
    const last = this.pace.at(-1);
    if (!last || now - last[0] > 1000 || last[0] - this.pace[0][0] < 300) return null;
    const factor = (1000 * (last[1] - this.pace[0][1])) / (last[0] - this.pace[0][0]);
    return factor > 0.001 ? factor : null;
  }

  tick(now, fps) {
    const factor = this.realTimeFactor(now);
    const stands = this.game.clock?.paused || (this.replay && !this.replay.playing);
    const pace = stands ? 'paused' : factor === null ? 'clock stands' : `${factor.toFixed(factor < 10 ? 2 : 0)} × real time`;
    $('speed').textContent = fps ? `${pace} · ${fps.toFixed(0)} fps` : pace;
  }

  offline() { $('problem').textContent = 'No connection to the server of this page'; }

  showSets(names, hidden) {
    const shown = names.slice(0, 60).join('\n');
    if (shown === this.setNames) return;
    this.setNames = shown;
    $('sets').replaceChildren(...names.slice(0, 60).map((name) => {
      const box = Object.assign(document.createElement('input'), { type: 'checkbox', checked: !hidden.has(name) });
      box.onchange = () => this.onSet(name, !box.checked);
      const label = document.createElement('label');
      label.append(box, name || '(no name)');
      return label;
    }));
  }
}
