// How far: before, after and floor, in total, per signal, and in behaviour.
report.bars = (answer, section) => {
  const { el, number } = report;
  const signals = (answer.per_signal ?? []).filter((s) => report.isNumber(s.before));
  const gap = answer.gap ?? {};
  const over = (x, floor) => (report.isNumber(x) && floor > 0 ? x / floor : 1);
  const most = Math.max(3, over(gap.before, gap.floor), ...signals.map((s) => over(s.before, s.floor)));
  const place = (ratio) => `${Math.min(100, Math.max(0.5, (100 * Math.log(Math.max(ratio, 0.5) / 0.5)) / Math.log(most / 0.5)))}%`;
  const row = (name, { before, after, floor }, unit, style = '') => [
    el('div', { class: style, title: name }, name),
    el('div', { class: 'track' }, el('i', { class: 'before', style: { width: place(over(before, floor)) } }),
      answer.verdict === 'none' ? null : el('i', { class: 'after', style: { width: place(over(after, floor)) } }), el('div', { class: 'mark', style: { left: place(1) } })),
    el('div', { class: `number ${style}` }, answer.verdict === 'none' ? number(before) : `${number(before)} \u2192 ${number(after)}`, el('span', { class: 'dim' }, `  floor ${number(floor)} ${unit}`))];
  section.append(el('p', { class: 'dim' }, 'Root mean square between measured and simulated, on data that were not used for the fit; the floor is what repeats and noise leave. Bars: multiples of the floor, logarithmic.'),
    report.legend([['before: nominal', report.colour('nominal')], ...(answer.verdict === 'none' ? [] : [['after: with the causes found', report.colour('corrected')]]), ['floor', report.colour('floor')]]));
  const bars = el('div', { class: 'gaps', id: 'gaps' }, gap.floor > 0 ? row('all signals', gap, report.unitOfGap(gap), 'total') : null);
  const sorted = [...signals].sort((a, b) => over(b.before, b.floor) - over(a.before, a.floor));
  const more = report.folded(sorted.map((s) => row(s.signal, s, report.unit(report.unitOfSignal(s.signal)))), 10, bars, 'signals');
  section.append(bars);
  if (more) section.append(more);
  const causes = answer.effects ?? [];
  if (causes.length > 1) {
    section.append(el('h3', { style: { marginTop: '20px' } }, 'What each cause contributes'),
      el('table', {}, el('tr', {}, el('th', {}, 'cause'), el('th', { class: 'number' }, 'closes alone'), el('th', { class: 'number' }, 'closes when added last')),
        causes.map((c) => el('tr', {}, el('td', {}, report.describe(c)), el('td', { class: 'number' }, report.percent(c.closed_alone ?? c.gap_closed)), el('td', { class: 'number' }, report.percent(c.closed_last))))));
  }
  if (answer.behaviour?.length) {
    section.append(el('h3', { style: { marginTop: '20px' } }, 'Behaviour in a free run'),
      el('table', {}, el('tr', {}, el('th', {}, ''), ['measured', 'nominal', 'corrected'].map((k) => el('th', { class: 'number' }, k))),
        answer.behaviour.map((b) => el('tr', {}, el('td', {}, b.what), ['measured', 'nominal', 'corrected'].map((k) => el('td', { class: 'number' }, report.withUnit(b[k], b.unit)))))));
  }
};

/** Of an answer by sets the gap is in the positions' own unit, of one by blocks in units of noise. */
report.unitOfGap = (gap) => ((gap.unit ?? '').startsWith('rad') ? 'rad' : 'noise');
