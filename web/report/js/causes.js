// Which: the causes found, how sure each is, and what these runs cannot tell from it.
report.causes = (answer, section) => {
  const { el, number, percent } = report;
  const causes = answer.effects ?? [];
  if (!causes.length) {
    section.append(el('p', {}, answer.verdict === 'none' ? 'There is nothing to explain.' : 'No effect of the library comes near enough to be named.'));
    return;
  }
  if (answer.verdict === 'unknown') section.append(el('p', { class: 'dim' }, 'The nearest explanations that the library has. They are not enough, and may be no more than neighbours of the true cause.'));
  else section.append(el('p', { class: 'dim' }, 'A probability is meant to be taken at its word: of the answers given with 90 %, nine in ten should be right. doc/results/gap-sets.md and gap-blocks.md of the project say how far that holds.'));
  const chance = (probability) => el('div', { class: 'chance' }, el('div', { class: 'bar' }, el('i', { style: { width: `${100 * Math.min(1, Math.max(0, probability))}%` } })), el('b', {}, percent(probability)));
  causes.forEach((cause, i) => {
    const rivals = [...(cause.confounded_with ?? [])].sort((a, b) => b.probability - a.probability);
    section.append(el('div', { class: 'cause' },
      el('div', { class: 'rank' }, i + 1),
      el('div', {},
        el('h3', {}, report.sentenceOf(cause)),
        el('div', { class: 'dim small' }, el('code', {}, cause.effect), ' at ', el('code', {}, cause.at === '*' ? 'all joints' : cause.at), cause.axis ? ` about ${cause.axis}` : '', cause.variant ? `, ${cause.variant}` : ''),
        chance(cause.probability),
        rivals.length ? el('div', { class: 'rivals' }, el('div', { class: 'small dim' }, 'These runs cannot tell it well from'),
          rivals.map((r) => el('div', {}, el('div', { class: 'small', title: r.sentence }, report.describe(r), report.isNumber(r.value) ? `, ${report.withUnit(r.value, r.unit)}` : ''), chance(r.probability)))) : null),
      el('div', { class: 'facts' }, report.range(cause),
        el('dl', {},
          el('dt', {}, 'value'), el('dd', {}, el('b', {}, report.withUnit(cause.value, cause.unit))),
          cause.interval ? [el('dt', {}, '95 % interval'), el('dd', {}, `${number(cause.interval[0])} to ${number(cause.interval[1])}`)] : [],
          report.isNumber(cause.nominal) ? [el('dt', {}, 'nominal'), el('dd', {}, number(cause.nominal))] : [],
          el('dt', {}, 'closes alone'), el('dd', {}, percent(cause.closed_alone ?? cause.gap_closed)),
          report.isNumber(cause.closed_last) ? [el('dt', {}, 'closes when added last'), el('dd', {}, percent(cause.closed_last))] : []))));
  });
  report.perJoint(answer, section);
  report.lost(answer, section);
};

/** What each kind of cause is worth in each joint, where that differs: a line per joint, bars of one scale per kind. */
report.perJoint = (answer, section) => {
  const { el, number } = report;
  const names = new Set((answer.figure?.joints ?? []).map((j) => j.name));
  const model = (answer.gap?.model ?? []).filter((c) => report.isNumber(c.value) && names.has(c.at));
  const joints = [...new Set(model.map((c) => c.at))];
  if (joints.length < 2) return;
  const kinds = [...new Set(model.map((c) => c.effect))].map((effect) => {
    const causes = model.filter((c) => c.effect === effect), unit = report.unit(causes[0].unit);
    return { name: unit ? `${effect} [${unit}]` : effect, most: Math.max(...causes.map((c) => Math.abs(c.value))) || 1, of: (joint) => causes.find((c) => c.at === joint)?.value };
  });
  const cell = ({ most, of }, joint) => (of(joint) === undefined ? el('td', {})
    : el('td', { class: 'number' }, number(of(joint)), el('div', { class: 'bar' }, el('i', { style: { width: `${(100 * Math.abs(of(joint))) / most}%` } }))));
  section.append(el('h3', { style: { marginTop: '18px' } }, 'Values in each joint'),
    el('p', { class: 'dim small' }, 'Each kind of cause with its value in every joint. The gap is closed with these, not with one value for all.'),
    el('table', { id: 'per-joint' }, el('tr', {}, el('th', {}, 'joint'), kinds.map(({ name }) => el('th', { class: 'number' }, name))),
      joints.map((joint) => el('tr', {}, el('td', {}, joint), kinds.map((kind) => cell(kind, joint))))));
};

/** What was weighed against the causes found and lost, and by how much. */
report.lost = (answer, section) => {
  const { el, percent } = report;
  const names = new Set((answer.effects ?? []).map((c) => report.describe(c)));
  const rows = (answer.effects ?? []).flatMap((cause) => (cause.confounded_with ?? []).map((rival) => ({ cause, rival })))
    .filter(({ rival }) => report.isNumber(rival.probability) && !names.has(report.describe(rival)))
    .sort((a, b) => b.rival.probability - a.rival.probability);
  section.append(el('h3', { style: { marginTop: '18px' } }, 'Causes that lost, and why'));
  if (!rows.length) {
    const least = Math.min(1, ...(answer.effects ?? []).map((c) => c.probability).filter(report.isNumber));
    section.append(el('p', { class: 'dim small' }, least > 0.9 ? 'Every other effect of the library, at every place, explains the data held back so much worse that less than 1 % is left for it.'
      : `No other cause stands out: the ${percent(1 - least)} that the least sure cause lacks are spread over sets without it.`));
    return;
  }
  section.append(el('table', { class: 'lost' }, el('tr', {}, ['instead of', 'the other cause', 'its best value'].map((t) => el('th', {}, t)), el('th', { class: 'number' }, 'probability'), el('th', {}, 'why it lost')),
    rows.map(({ cause, rival }) => el('tr', {}, el('td', {}, report.describe(cause)), el('td', {}, report.describe(rival)),
      el('td', {}, report.isNumber(rival.value) ? report.withUnit(rival.value, rival.unit) : ''), el('td', { class: 'number' }, percent(rival.probability)),
      el('td', {}, `even with its best value it explains the data held back worse: the odds are ${report.odds(cause.probability, rival.probability)} against it`)))),
  el('p', { class: 'dim small' }, 'All other effects and places have less than 1 %.'));
};

/** "12 to 1", from two probabilities. */
report.odds = (won, lost) => (lost > 0 && won > lost ? `${report.number(won / lost, 2)} to 1` : 'even');

/** The value with its interval on an axis that shows the nominal value too. */
report.range = (cause) => {
  const { el, isNumber, number } = report;
  const [lower, upper] = cause.interval ?? [cause.value, cause.value];
  const points = [cause.value, lower, upper, cause.nominal].filter(isNumber);
  if (!isNumber(cause.value) || points.length < 2) return null;
  const least = Math.min(...points), most = Math.max(...points), margin = 0.12 * (most - least || Math.abs(most) || 1);
  const at = (x) => `${(100 * (x - least + margin)) / (most - least + 2 * margin)}%`;
  return el('div', { class: 'range' }, el('div', { class: 'axis' }),
    isNumber(lower) && isNumber(upper) ? el('div', { class: 'span', style: { left: at(lower), right: `calc(100% - ${at(upper)})` } }) : null,
    isNumber(cause.nominal) ? [el('div', { class: 'nominal', style: { left: at(cause.nominal) } }), el('small', { style: { left: at(cause.nominal) } }, 'nominal')] : null,
    el('div', { class: 'value', style: { left: at(cause.value) }, title: number(cause.value) }));
};
