// Each recording by itself: what was left of its gap by an answer that did not see it, and by bin/gap check on others.
report.recordings = (answer, section) => {
  const { el, number, percent } = report;
  const leftOut = answer.gap?.runs ?? [], checked = answer.check?.runs ?? [];
  if (!leftOut.length && !checked.length) {
    section.hidden = true;
    return;
  }
  const row = (name, { before, after, floor, closed }, unit, style = '') => el('tr', { class: style }, el('td', { title: name }, name),
    el('td', { class: 'number' }, report.thousandths(before, unit)), el('td', { class: 'number' }, report.thousandths(after, unit)),
    el('td', { class: 'number' }, report.isNumber(floor) ? report.thousandths(floor, unit) : 'no repeat'),
    el('td', { class: 'number' }, percent(closed ?? report.closedOf(before, after, floor))));
  const table = (runs) => {
    const rows = el('table', { class: 'recordings' }, el('tr', {}, el('th', {}, 'recording'), ['before', 'after', 'floor', 'closed'].map((t) => el('th', { class: 'number' }, t))));
    const joints = [];
    runs.forEach((run, i) => {
      rows.append(row(report.runName(run, i), run, 'rad', 'total'));
      const positions = Object.entries(run.signals ?? {}).filter(([signal]) => signal.startsWith('pos.'));
      if (positions.length > 1) joints.push(...positions.map(([signal, of]) => row(`${report.runName(run, i)}: ${signal.slice(4)}`, of, of.unit)));
    });
    if (!joints.length) return [rows];
    return [rows, el('details', {}, el('summary', {}, `Each joint (${joints.length} lines)`), el('table', { class: 'recordings' }, joints))];
  };
  section.append(el('p', { class: 'dim' }, 'Root mean squares of the positions, replayed free from the first sample. The floor is what repeats of a recording differ by.'));
  if (leftOut.length) {
    section.append(el('h3', {}, answer.gap.left_out === 'recordings' ? 'Recordings left out of search and fit, each in turn' : 'The one recording, its stretches left out in turn'), ...table(leftOut));
    if (report.isNumber(answer.gap.closed)) {
      const [lower, upper] = answer.gap.closed_interval ?? [];
      section.append(el('p', { class: 'small' }, `Of a recording that it has not seen the answer claims ${percent(answer.gap.closed)}`, report.isNumber(lower) ? ` (90\u202f%: ${percent(lower)} to ${percent(upper)}).` : '.'));
    }
  }
  if (answer.gap?.further?.sentence) section.append(el('p', { id: 'further' }, answer.gap.further.sentence));
  if (checked.length) section.append(el('h3', { style: { marginTop: '18px' } }, 'Recordings that it never saw'), ...table(checked),
    el('p', { class: 'small', id: 'checked' }, `Closed on average ${percent(answer.check.closed)}; the answer claims ${percent(answer.check.claimed)}.`));
};

/** Radians as mrad, metres as mm, anything else in its unit. */
report.thousandths = (x, unit) => ({ rad: report.withUnit(1000 * x, 'mrad'), m: report.withUnit(1000 * x, 'mm') })[unit] ?? report.withUnit(x, unit);
report.closedOf = (before, after, floor) => (before > (floor ?? 0) ? (before - after) / (before - (floor ?? 0)) : 0);

/** The answer in one sentence for who decides and does not diagnose. */
report.inShort = (answer) => {
  const { percent } = report, causes = answer.effects ?? [], closed = answer.gap?.closed;
  if (answer.verdict === 'none') return 'In short: for these motions the simulator can be trusted as it is.';
  const names = [...new Set(causes.map((c) => `${report.nameOf(c.effect)} at ${report.placeOf(c)}`))];
  const list = names.length > 1 ? `${names.slice(0, -1).join(', ')} and ${names.at(-1)}` : names[0];
  const share = report.isNumber(closed) ? Math.max(0, Math.min(1, closed)) : null;
  if (answer.verdict === 'unknown') {
    return names.length ? `In short: the simulator is wrong in a way that we do not fully understand; what comes nearest, ${list}, removes ${share === null ? 'a part' : percent(share)} of its error, so measure again before building on it.`
      : 'In short: the simulator is wrong in a way that we do not understand; measure again before building on it.';
  }
  return `In short: the simulator lacks ${list}; with ${names.length > 1 ? 'them' : 'it'} in, ${share === null ? 'a part' : `about ${percent(share)}`} of its error is expected to go.`;
};
