// What to do next, and what the verdict rests on.
report.next = (answer, section) => {
  const { el } = report;
  section.append(el('p', { id: 'nextMotion' }, answer.next_motion || 'Nothing is needed.'));
  if (answer.verdict === 'none') return;
  section.append(el('div', { class: 'small dim' }, 'Design that motion for this robot, and put the causes found into a simulator:'),
    el('pre', {}, 'bin/gap next answer.json -o next.yaml\nbin/gap apply answer.json -o effects.yaml'));
};

report.data = (answer, section) => {
  const { el } = report;
  const runs = answer.runs ?? [];
  const left = runs.flatMap((r, i) => (r.left_out ?? []).map((l) => ({ run: report.runName(r, i), ...l })));
  const out = left.filter((l) => l.left_out !== false), care = left.filter((l) => l.left_out === false);
  section.append(el('table', {}, el('tr', {}, ['run', 'motion', 'base'].map((t) => el('th', {}, t)), el('th', { class: 'number' }, 'length')),
    runs.map((r, i) => el('tr', {}, el('td', { title: r.folder }, report.runName(r, i)), el('td', {}, r.motion), el('td', {}, r.base === 'free' ? 'on its feet' : 'held'),
      el('td', { class: 'number' }, report.withUnit(r.duration_s, 's'))))));
  const list = (title, entries) => entries.length ? [el('h3', { style: { marginTop: '18px' } }, title),
    el('table', {}, entries.map((l) => el('tr', {}, el('td', {}, l.run), el('td', {}, el('code', {}, l.channel)), el('td', {}, l.why))))] : [];
  section.append(...list('Left out, and why', out), ...list('To be taken with care', care));
  if (!left.length) section.append(el('p', { class: 'dim small', style: { marginTop: '10px' } }, 'No channel was left out.'));
  for (const remark of answer.remarks ?? []) section.append(el('p', { class: 'small' }, remark));
};
