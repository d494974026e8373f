// The verdict in a sentence, and the numbers that matter most.
report.verdict = (answer, section) => {
  const { el, number, percent } = report;
  const causes = answer.effects ?? [], gap = answer.gap ?? {};
  const sure = causes.length ? Math.min(...causes.map((c) => c.probability)) : 1;
  const badge = answer.verdict === 'none' ? ['none', 'No gap beyond noise'] : answer.verdict === 'unknown' ? ['unknown', 'Cause unknown']
    : [sure < 0.65 ? 'unsure' : 'effect', causes.length > 1 ? `${causes.length} causes found` : 'Cause found'];
  const tile = (value, text) => el('div', { class: 'tile' }, el('b', {}, value), el('small', {}, text));
  // A long name goes on in a second line: after its dots if it can.
  const broken = (name) => name.split('.').flatMap((part, i) => (i ? ['.', el('wbr'), part] : [part]));
  const cells = answer.map?.cells ?? answer.where ?? [];
  const top = cells.reduce((a, b) => ((b.share ?? 0) > (a?.share ?? 0) ? b : a), null);
  const inRadians = report.unitOfGap(gap) === 'rad';
  const unit = gap.unit ?? 'units of each signal\u2019s noise';
  section.append(
    el('span', { class: `badge ${badge[0]}` }, badge[1]),
    el('h1', { id: 'sentence' }, report.headline(answer)),
    el('p', { id: 'short' }, report.inShort(answer)),
    el('p', { class: 'dim', id: 'caveat' }, report.caveat(answer)),
    el('div', { class: 'tiles' },
      inRadians ? tile(`${number(1000 * gap.before)} \u2192 ${number(1000 * gap.after)}\u202fmrad`, 'error of the positions before and after, on recordings left out (mm for sliding joints)')
        : tile(`${number(gap.before)} \u2192 ${number(gap.after)}`, `gap before and after, ${unit}${gap.held_out ? '; on data that were not used for the fit' : ''}`),
      answer.verdict === 'none' ? tile(number(gap.floor), 'the floor: what repeats and noise leave')
        : tile(percent(gap.closed), inRadians ? 'of the error of a recording that was not seen is expected to go' : `of what can be closed is closed; floor ${number(gap.floor)}`),
      top && answer.verdict !== 'none' ? tile(broken(top.signal), `shows most of it: ${percent(top.share)} of the gap, in ${top.phase}`) : null,
      report.isNumber(answer.known_probability) && answer.verdict !== 'none' ? tile(percent(answer.known_probability), 'chance that the known effects are the whole story') : null));
};
