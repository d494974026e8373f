// What strikers decided: which decision holds at a moment, and how it is shown.
const decisionLasts = 1.5; // [s of the game]

// The last line of each player that is no older; `players` as bin/webmonitor --summary writes them, or null.
function decisionsAt(players, clock) {
  return (players ?? []).flatMap(({ side, unum, lines }) => {
    let low = 0, high = lines.length; // the first line after this moment is at `low`
    while (low < high) {
      const middle = (low + high) >> 1;
      if (lines[middle][0] <= clock + 1e-6) low = middle + 1;
      else high = middle;
    }
    if (!low || clock - lines[low - 1][0] > decisionLasts) return [];
    const [at, x, y, actions] = lines[low - 1];
    return [{ side, unum, at, x, y, actions: actions.map(([action, endX, endY, value, goal]) => ({ action, x: endX, y: endY, value, goal })) }];
  });
}

function drawDecision(c, { side, x, y, actions }, pixel) {
  actions.forEach((action, rank) => {
    c.strokeStyle = rank ? 'rgba(255,255,255,0.55)' : colours[side];
    c.lineWidth = (rank ? 1.2 : 3) * pixel;
    c.setLineDash(rank ? [5 * pixel, 5 * pixel] : []);
    arrow(c, x, y, action.x, action.y, pixel);
  });
  c.setLineDash([]);
}

// One table of each player: the chosen action first, then what it decided against.
function showDecisions(place, decided, names) {
  if (!decided.length) return place.replaceChildren(element('p', 'No striker decides at this moment.'));
  place.replaceChildren(...decided.map(({ side, unum, actions }) => {
    const table = document.createElement('table'), caption = element('caption', `Number ${unum} of ${names[side]}`);
    caption.style.color = colours[side];
    const head = element('tr');
    head.append(...['decides for', 'the ball ends at', 'value', 'goal'].map((text) => element('th', text)));
    table.append(caption, head, ...actions.map((action, rank) => {
      const row = element('tr', '', rank ? 'rejected' : 'chosen');
      row.append(element('td', rank ? `rather than ${action.action}` : action.action),
        ...[`${action.x.toFixed(1)}, ${action.y.toFixed(1)} m`, action.value.toFixed(3), `${Math.round(100 * action.goal)} %`].map((text) => element('td', text)));
      return row;
    }));
    return table;
  }));
}

if (typeof module !== 'undefined') module.exports = { decisionsAt };
