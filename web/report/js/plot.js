// One way of drawing curves for the whole page (uPlot), in the page's colours and width.
report.plot = (container, { series, data, height = 210, unit = '', sync, logarithmic = false, fill = false }) => {
  const line = report.colour('line'), dim = report.colour('dim');
  const axis = { stroke: dim, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 5 }, font: '11.5px system-ui, sans-serif' };
  const value = (_, x) => (x === null || x === undefined ? '\u2007' : report.withUnit(x, unit));
  const options = {
    width: Math.max(260, container.clientWidth), height,
    cursor: { drag: { x: true, y: false, uni: 10 }, ...(sync ? { sync: { key: sync } } : {}) },
    scales: { x: { time: false }, y: logarithmic ? { distr: 3 } : {} },
    axes: [{ ...axis, values: (_, ticks) => ticks.map((t) => `${Number(t.toFixed(3))} s`) }, { ...axis, size: 58, values: (_, ticks) => ticks.map((t) => (t === null ? '' : report.number(t))) }],
    series: [{ label: 'time', value: (_, t) => (t === null || t === undefined ? '\u2007' : `${t.toFixed(2)} s`) },
      ...series.map((s) => ({ label: s.label, stroke: s.faint ? `${s.colour}66` : s.colour, width: s.width ?? 1.4, dash: s.dash, value, points: { show: false },
        ...(fill ? { fill: `${s.colour}22` } : {}), ...(s.points ? { width: 0, points: { show: true, size: 3, fill: s.colour, stroke: s.colour } } : {}) }))],
  };
  const plot = new uPlot(options, data, container);
  new ResizeObserver(() => {
    const width = Math.max(260, container.clientWidth);
    if (width !== plot.width) plot.setSize({ width, height });
  }).observe(container);
  return plot;
};
report.legend = (entries) => report.el('div', { class: 'legend' }, entries.map(([name, colour]) => report.el('span', {}, report.el('i', { style: { background: colour } }), name)));
