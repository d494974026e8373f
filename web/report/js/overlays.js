// The channels that miss most: measured, nominal and corrected on top of each other, or their difference.
report.overlays = (answer, section) => {
  const { el } = report;
  const overlays = (answer.overlays ?? []).filter((o) => o.t?.length > 1);
  if (!overlays.length) {
    section.hidden = true;
    return;
  }
  const colours = { measured: report.colour('measured'), nominal: report.colour('nominal'), corrected: report.colour('corrected') };
  const keys = answer.verdict === 'none' ? ['measured', 'nominal'] : ['measured', 'nominal', 'corrected'];
  const plots = el('div', { class: 'plots' });
  let drawn = [];
  const draw = (difference) => {
    for (const plot of drawn) plot.destroy();
    plots.replaceChildren();
    drawn = overlays.map((o) => {
      const box = el('div', { class: 'plot' }, el('h3', {}, o.signal, el('span', {}, report.runName(answer.runs?.[o.run] ?? {}, o.run), o.unit ? `, ${report.unit(o.unit)}` : '')));
      plots.append(box);
      const shown = difference ? keys.filter((k) => k !== 'measured') : keys;
      const values = (key) => o[key].map((x, i) => (!report.isNumber(x) ? null : difference ? (report.isNumber(o.measured[i]) ? o.measured[i] - x : null) : x));
      return report.plot(box, { series: shown.map((k) => ({ label: difference ? `measured \u2212 ${k}` : k, colour: colours[k], ...(k === 'measured' ? { width: 4, faint: true } : {}) })), data: [o.t, ...shown.map(values)], unit: o.unit, sync: `run${o.run}` });
    });
  };
  const buttons = [['Difference to measured', true], ['Signals', false]].map(([text, difference]) => el('button', { onclick: (event) => {
    for (const b of buttons) b.classList.toggle('chosen', b === event.currentTarget);
    draw(difference);
  } }, text));
  buttons[0].classList.add('chosen');
  section.append(el('p', { class: 'dim' }, 'First the difference, as the curves themselves often lie on each other. Drag over a plot to zoom in, double-click to see all again.'),
    el('div', { class: 'tools' }, buttons, report.legend(keys.map((k) => [k, colours[k]]))), plots);
  draw(true);
  report.shown = () => [drawn[0].scales.x.min, drawn[0].scales.x.max]; // times that the first plot shows [s]
};
