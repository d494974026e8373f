// The verdict in words that promise no more than the numbers do.
report.lowerFirst = (text) => (/^[A-Z][a-z]/.test(text) ? text[0].toLowerCase() + text.slice(1) : text);
report.placeOf = (cause) => (cause.at === '*' ? 'every joint' : cause.at) + (cause.axis ? `, axis ${cause.axis}` : '');
report.nameOf = (effect) => effect.replaceAll('_', ' ');
report.describe = (cause) => `${report.nameOf(cause.effect)} at ${report.placeOf(cause)}`;
report.sentenceOf = (cause) => (cause.sentence ?? `${report.describe(cause)}.`).replace(/\.$/, '');

report.sure = (probability) => {
  if (probability >= 0.97) return 'Almost certainly';
  if (probability >= 0.85) return 'Very likely';
  if (probability >= 0.65) return 'Probably';
  if (probability >= 0.45) return 'Perhaps';
  return 'Undecided, but first in line';
};

report.headline = (answer) => {
  const causes = answer.effects ?? [];
  if (answer.verdict === 'none') return 'Nothing is missing: the nominal simulator explains these runs down to their noise.';
  if (answer.verdict === 'unknown') return 'Something is missing that none of the known effects explains.';
  const parts = causes.map((c, i) => `${i === 0 ? '' : `${report.sure(c.probability).toLowerCase()} `}${report.lowerFirst(report.sentenceOf(c))} (${report.percent(c.probability)})`);
  if (parts.length === 0) return 'An effect is missing; the answer does not name it.';
  const sentence = parts.length === 1 ? parts[0] : `${parts.slice(0, -1).join('; ')}; and ${parts.at(-1)}`;
  return `${report.sure(causes[0].probability)} ${sentence}.`;
};

/** What else a reader should know before believing the headline. */
report.caveat = (answer) => {
  const causes = answer.effects ?? [];
  if (answer.verdict === 'none') {
    return 'That holds for the motions recorded here. What they do not excite can still be missing; faster moves, higher loads and slow reversals would show smaller effects.';
  }
  if (answer.verdict === 'unknown') {
    const left = answer.worst && report.isNumber(answer.worst.after) ? ` In ${answer.worst.signal}, ${report.number(answer.worst.after, 2)} times the noise remain.` : '';
    const nearest = causes.length ? ` The nearest known explanation, ${report.describe(causes[0])}, is listed below; it is not enough, so do not build on it.` : '';
    return `The runs have structure that no effect of the library explains.${left}${nearest}`;
  }
  const open = causes.filter((c) => (c.confounded_with ?? []).some((r) => r.probability >= 0.1));
  if (open.length) {
    const rival = open[0].confounded_with.reduce((a, b) => (a.probability >= b.probability ? a : b));
    return `These runs do not rule out another explanation: ${report.lowerFirst(report.sentenceOf(rival))} (${report.percent(rival.probability)}). What would separate them is below.`;
  }
  const weakest = Math.min(...causes.map((c) => c.probability));
  return weakest < 0.65 ? 'The data are thin for this verdict; take it as a hint of what to record next.' : 'No other effect of the library explains the runs nearly as well.';
};
