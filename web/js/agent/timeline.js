// Keyframes along the time: choose one, drag it to another time, go to any time between them.
import { make } from './dom.js';

export class Timeline {
  constructor({ place, onChoose, onTime, onDrag, onDragged }) {
    Object.assign(this, { onChoose, onTime, onDrag, onDragged });
    this.slider = make('input', { type: 'range', id: 'editorTime', min: 0, step: 0.001, value: 0, set: { 'aria-label': 'Time of the motion' } });
    this.slider.oninput = () => this.onTime(Number(this.slider.value));
    this.track = make('div', { className: 'track' });
    this.clock = make('span', { className: 'clock' });
    place.append(make('div', { className: 'ruler' }, this.slider, this.track), this.clock);
  }

  // warnings: per keyframe a text or ''.
  show(motion, chosen, warnings) {
    const times = motion.times(), end = Math.max(motion.seconds, 1e-3);
    this.slider.max = end;
    this.track.replaceChildren(...motion.keyframes.flatMap((keyframe, i) => {
      const from = times[i] - keyframe.time;
      const span = make('i', { className: warnings[i] ? 'span fast' : 'span', textContent: keyframe.time > 0.06 * end ? `${keyframe.time} s` : '', title: warnings[i] || `${keyframe.time} s to keyframe ${i + 1}` });
      span.style.left = `${(100 * from) / end}%`;
      span.style.width = `${(100 * keyframe.time) / end}%`;
      const mark = make('button', { className: `key${i === chosen ? ' chosen' : ''}${keyframe.settle > 0 ? ' settles' : ''}`, textContent: i + 1, title: keyframe.settle > 0 ? `waits up to ${keyframe.settle} s until the torso is still` : `keyframe ${i + 1}` });
      mark.dataset.keyframe = i;
      mark.style.left = `${(100 * times[i]) / end}%`;
      mark.onpointerdown = (event) => this.drag(event, mark, i, times[i], end);
      mark.onclick = () => this.onChoose(i);
      return [span, mark];
    }));
  }

  at(seconds) {
    this.slider.value = seconds;
    this.clock.textContent = `${seconds.toFixed(2)} of ${Number(this.slider.max).toFixed(2)} s`;
  }

  drag(event, mark, index, time, end) {
    const begin = event.clientX, width = this.track.clientWidth || 1;
    const move = ({ clientX }) => {
      if (Math.abs(clientX - begin) < 3 && !this.dragging) return;
      this.dragging = true;
      this.onDrag(index, time + ((clientX - begin) / width) * end);
    };
    const stop = () => {
      removeEventListener('pointermove', move);
      removeEventListener('pointerup', stop);
      if (this.dragging) this.onDragged(index);
      this.dragging = false;
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', stop);
  }
}
