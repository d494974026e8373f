// The goals of a recording as marks above its slider; a click goes to a moment before the goal.
import { cssColour, teamColours } from './teams.js';

const before = 3; // [s]

export class GoalMarks {
  constructor(place, onSeek) { Object.assign(this, { place, onSeek }); }

  show({ goals = [], duration }) {
    const key = JSON.stringify([goals, duration, teamColours]);
    if (key === this.shown) return;
    this.shown = key;
    this.place.replaceChildren(...goals.map(({ time, side }) => {
      const mark = document.createElement('button');
      mark.style.left = `${(100 * time) / (duration || 1)}%`;
      mark.style.background = cssColour(teamColours[side] ?? teamColours.none);
      mark.title = `Goal of the ${side} team`;
      mark.onclick = () => this.onSeek(Math.max(0, time - before));
      return mark;
    }));
  }
}
