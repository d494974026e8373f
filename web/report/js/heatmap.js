// Where: a row per signal, a column per phase, colour by gap in units of noise.
report.ratio = (cell) => (cell.noise_rms > 0 ? cell.gap_rms / cell.noise_rms : cell.gap_rms > 0 ? Infinity : 1);

/** Signals with their cells, those with the largest share of the gap first. */
report.rowsOf = (cells) => {
  const rows = new Map();
  for (const cell of cells) {
    const row = rows.get(cell.signal) ?? rows.set(cell.signal, { signal: cell.signal, share: 0, worst: 1, cells: new Map() }).get(cell.signal);
    row.cells.set(cell.phase, cell);
    row.share += Math.max(0, cell.share ?? 0);
    row.worst = Math.max(row.worst, Math.min(1e4, report.ratio(cell)));
  }
  return [...rows.values()].sort((a, b) => b.share - a.share || b.worst - a.worst);
};

report.heatmap = (answer, rows, most) => {
  const { el, number, percent } = report;
  const order = ['static hold', 'reversal', 'motion', 'high speed', 'high load', 'impact', 'left support', 'right support'];
  const present = new Set(rows.flatMap((r) => [...r.cells.keys()]));
  const phases = [...order.filter((p) => present.has(p)), ...[...present].filter((p) => !order.includes(p))];
  const largest = Math.max(1e-9, ...rows.map((r) => r.share));
  const map = el('div', { class: 'map', id: 'map', style: { gridTemplateColumns: `minmax(110px, 160px) repeat(${phases.length}, minmax(44px, 1fr)) 120px` } },
    el('div', { class: 'head' }, 'signal'), phases.map((p) => el('div', { class: 'head' }, p)), el('div', { class: 'head' }, 'share of the gap'));
  const lines = rows.map((row) => [
    el('div', { class: 'name', 'data-signal': row.signal, title: row.signal }, row.signal),
    ...phases.map((phase) => {
      const cell = row.cells.get(phase);
      if (!cell) return el('div', { class: 'cell empty', title: `${row.signal}: no ${phase} in these runs` });
      const ratio = report.ratio(cell), colour = report.heat(ratio, most), unit = report.unitOfSignal(row.signal);
      return el('div', { class: 'cell', style: { background: colour.fill, color: colour.ink },
        title: `${row.signal}, ${phase}: ${report.withUnit(cell.gap_rms, unit)} rms where noise is ${report.withUnit(cell.noise_rms, unit)}; ${percent(cell.share)} of the whole gap` },
      ratio >= 1.05 ? (Number.isFinite(ratio) ? number(ratio, 2) : '\u221e') : '');
    }),
    el('div', { class: 'share' }, el('i', { style: { width: `${Math.max(0, 66 * row.share / largest)}px` } }), el('span', { class: 'number dim' }, row.share >= 0.005 ? percent(row.share) : '')),
  ]);
  const more = report.folded(lines, 16, map, 'signals');
  const scale = el('canvas', { width: 190, height: 10 });
  const context = scale.getContext('2d');
  for (let x = 0; x < 190; ++x) {
    context.fillStyle = report.heat(most ** (x / 189), most).fill;
    context.fillRect(x, 0, 1, 10);
  }
  return el('div', {}, map, more, el('div', { class: 'scale' }, 'noise', scale, `${number(most, 2)} times the noise`));
};
