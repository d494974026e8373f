// Puts the page together from the answer it holds.
(() => {
  const { el } = report;
  const answer = JSON.parse(document.getElementById('answer').textContent);
  const section = (id) => document.getElementById(id);
  const runs = answer.runs ?? [];
  const seconds = runs.reduce((sum, r) => sum + (r.duration_s ?? 0), 0);
  document.title = `Gap report: ${answer.robot ?? 'robot'}`;
  section('about').append(el('b', {}, answer.robot ?? ''), ` \u00b7 ${runs.length} ${runs.length === 1 ? 'run' : 'runs'}, ${report.number(seconds)} s`);
  report.verdict(answer, section('verdict'));

  const rows = report.rowsOf(answer.map?.cells ?? answer.where ?? []);
  if (rows.length) {
    const most = Math.max(10, ...rows.map((r) => r.worst));
    const figure = report.figure(answer.figure, rows, most);
    section('where').append(el('p', { class: 'dim' }, 'Difference between the runs and the nominal simulator, as a multiple of each signal\u2019s own noise, by what the joint or robot was doing.'),
      figure ? el('div', { class: 'split' }, report.heatmap(answer, rows, most), figure) : report.heatmap(answer, rows, most));
  } else section('where').hidden = true;
  report.tracks(answer, section('when'));
  report.causes(answer, section('causes'));
  report.overlays(answer, section('overlays'));
  report.recordings(answer, section('recordings'));
  report.bars(answer, section('far'));
  report.next(answer, section('next'));
  report.data(answer, section('data'));
  document.body.dataset.ready = 'yes';
})();
