// When: the gap over the time of each run, before and after.
report.tracks = (answer, section) => {
  const { el } = report;
  const tracks = (answer.map?.time ?? []).filter((t) => t.start?.length > 1);
  if (!tracks.length) {
    section.hidden = true;
    return;
  }
  const names = { before: 'nominal', after: 'with the causes found' };
  section.append(el('p', { class: 'dim' }, 'Gap over all channels in each half second, in units of noise. Drag to zoom, double-click to see all.'),
    report.legend([[names.before, report.colour('nominal')], ...(answer.verdict === 'none' ? [] : [[names.after, report.colour('corrected')]]), ['floor: 1', report.colour('floor')]]));
  const plots = el('div', { class: 'plots' });
  section.append(plots);
  for (const track of tracks) {
    const run = answer.runs?.[track.run] ?? {};
    const box = el('div', { class: 'plot' }, el('h3', {}, report.runName(run, track.run), el('span', { title: run.motion }, run.motion ?? '')));
    plots.append(box);
    const clean = (values) => values.map((x) => (report.isNumber(x) ? Math.max(x, 0.05) : null));
    const series = [{ label: names.before, colour: report.colour('nominal') }];
    const data = [track.start, clean(track.before)];
    if (answer.verdict !== 'none') {
      series.push({ label: names.after, colour: report.colour('corrected') });
      data.push(clean(track.after));
    }
    series.push({ label: 'floor', colour: report.colour('floor'), width: 1, dash: [4, 4] });
    data.push(track.start.map(() => 1));
    report.plot(box, { series, data, height: 150, logarithmic: true });
  }
};
/** The last two parts of a run's folder are enough to know it. */
report.runName = (run, index) => (run.folder ? run.folder.split('/').filter(Boolean).slice(-1)[0] : `run ${index + 1}`);
