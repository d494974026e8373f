// Score board, trainer's buttons and the bar of a recorded match.
import { GoalMarks } from './marks.js';

const oneFrame = 0.04; // between two pictures of a recording [s]
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
    this.game = { live: true, clock: null, connected: false };
    this.online = false;
    this.replay = null;
    for (const button of document.querySelectorAll('[data-camera]')) button.onclick = () => this.camera(button.dataset.camera);
    for (const button of document.querySelectorAll('[data-do]')) button.onclick = () => this.trainer(button.dataset.do);
    $('rate').onchange = () => send({ do: 'speed', speed: Number($('rate').value) });
    $('showLabels').onchange = () => onLabels($('showLabels').checked);
    $('showDrawings').onchange = () => onDrawings($('showDrawings').checked);
    $('replayPlay').onclick = () => this.togglePlay();
    for (const button of document.querySelectorAll('[data-skip]')) button.onclick = () => this.skip(Number(button.dataset.skip));
    this.marks = new GoalMarks($('replayMarks'), (time) => send({ do: 'seek', time }));
    $('replayTime').oninput = () => send({ do: 'seek', time: Number($('replayTime').value) });
    $('replayRate').onchange = () => send({ do: 'rate', rate: Number($('replayRate').value) });
    window.addEventListener('keydown', (e) => this.key(e));
    this.pace = [];
  }

  key(event) {
    const field = document.activeElement;
    if (field?.id === 'replayTime') field.blur();
    else if (/INPUT|SELECT/.test(field?.tagName) && event.key !== 'Escape') return;
    const cameras = ['free', 'side', 'ball', 'robot', 'top'];
    if (cameras[Number(event.key) - 1]) this.camera(cameras[Number(event.key) - 1]);
    if (event.key === ' ') {
      event.preventDefault();
      if (this.replay) this.togglePlay();
      else this.trainer('pause');
    }
    if (this.replay) {
      const skip = { ArrowLeft: -5, ArrowRight: 5, ',': -oneFrame, '.': oneFrame }[event.key];
      if (skip) this.skip(skip);
      if (skip) event.preventDefault();
    } else if (event.key === '.') {
      this.trainer('step');
    }
  }

  camera(mode) {
    for (const button of document.querySelectorAll('[data-camera]')) button.classList.toggle('chosen', button.dataset.camera === mode);
    this.onCamera(mode);
  }

  // Whether a server listens to the trainer's buttons.
  playable() { return Boolean(this.online && this.game.live && this.game.connected !== false); }

  trainer(what) {
    if (!this.playable()) return;
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

  // To another time of the recording [s]; a step by one frame stops it.
  skip(seconds) {
    if (!this.replay) return;
    if (Math.abs(seconds) < 1 && this.replay.playing) this.send({ do: 'stop' });
    const time = Math.max(0, Math.min(this.replay.duration, this.replay.time + seconds));
    this.replay.time = time;
    this.send({ do: 'seek', time });
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
    this.say(game.problem);
    $('trainer').hidden = !game.live;
    $('clock').title = game.live ? 'Time of the match' : 'Time of the recorded match';
    this.enable();
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
    $('replayClock').textContent = `recording ${clockText(replay.time)} of ${clockText(replay.duration)}`;
    if (replay.problem) this.say(replay.problem);
    this.marks.show(replay);
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

  tick(now, fps, robots) {
    $('empty').hidden = !(this.playable() && robots === 0);
    const factor = this.realTimeFactor(now);
    const stands = this.game.clock?.paused || (this.replay && !this.replay.playing);
    const pace = stands ? 'paused' : factor === null ? 'clock stands' : `${factor.toFixed(factor < 10 ? 2 : 0)} × real time`;
    $('speed').textContent = fps ? `${pace} · ${fps.toFixed(0)} fps` : pace;
  }

  // One line about what is wrong, in a place of its own; empty: nothing is.
  say(problem) {
    $('problem').textContent = problem ?? '';
    $('problem').hidden = !problem;
  }

  setOnline(online) {
    this.online = online;
    if (!online) this.say('No connection to the server of this page; it connects again by itself');
    else this.say(this.game.problem);
    this.enable();
  }

  enable() {
    const playable = this.playable();
    for (const element of document.querySelectorAll('#trainer button, #trainer select')) {
      const can = playable && (!element.hasAttribute('data-clock') || this.game.clock);
      element.disabled = !can;
      element.dataset.help ??= element.title;
      element.title = can ? element.dataset.help : playable ? 'This server cannot do that' : 'No simulator is connected';
    }
  }

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
