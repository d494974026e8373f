# A diagram as SVG from lines "series x y [low high]", divided by tabs, in the order of drawing. Variables: title, xLabel, yLabel.
# A series whose name begins with "thesis" is dashed. Also: marks: 1 for points with bars instead of lines; logY: 1 for a
# logarithmic axis; xNames: names of the places 0, 1, ... on the axis, divided by "|".
BEGIN { FS = "\t"; width = 640; height = 380; left = 70; right = 16; top = 34; bottom = 50 }
NF >= 3 {
  if (!($1 in number)) { number[$1] = ++series; name[series] = $1 }
  s = number[$1]; k = ++count[s]; x[s, k] = $2 + 0; y[s, k] = $3 + 0; low[s, k] = high[s, k] = $3 + 0; barred[s, k] = NF >= 5
  if (NF >= 5) { low[s, k] = $4 + 0; high[s, k] = $5 + 0 }
  if (!any++) { x0 = x1 = $2 + 0; y0 = low[s, k]; y1 = high[s, k] }
  if ($2 + 0 < x0) x0 = $2 + 0
  if ($2 + 0 > x1) x1 = $2 + 0
  if (low[s, k] < y0) y0 = low[s, k]
  if (high[s, k] > y1) y1 = high[s, k]
}
function scaled(v) { return logY ? log(v) : v }
function px(v) { return left + (v - x0) / (x1 - x0) * (width - left - right) }
function py(v) { return height - bottom - (scaled(v) - scaled(y0)) / (scaled(y1) - scaled(y0)) * (height - top - bottom) }
# A distance of ticks that is 1, 2 or 5 times a power of ten.
function step(range, most,   raw, power) {
  raw = range / most; power = 10 ^ int(log(raw) / log(10) + (raw < 1 ? -1 : 0) + 1e-9)
  return raw <= power ? power : raw <= 2 * power ? 2 * power : raw <= 5 * power ? 5 * power : 10 * power
}
function text(at, up, words, more) { printf "<text x=\"%.1f\" y=\"%.1f\" %s>%s</text>\n", at, up, more, words }
function yTick(v) {
  printf "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", left, width - right, py(v), py(v)
  text(left - 6, py(v) + 4, sprintf("%g", v), "text-anchor=\"end\"")
}
function xTick(v, words) {
  printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\" stroke=\"black\"/>\n", px(v), px(v), height - bottom, height - bottom + 4
  text(px(v), height - bottom + 18, words, "text-anchor=\"middle\"")
}
END {
  if (!any) { print "diagram.awk: nothing to draw" > "/dev/stderr"; exit 1 }
  split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #555555 #8c564b #17becf", colour, " ")
  if (!logY) { if (y0 > 0) y0 = 0; y1 += (y1 - y0) / 20 }
  if (y1 == y0) y1 = y0 + 1
  names = split(xNames, word, "|")
  if (names) { x0 = -0.5; x1 = names - 0.5 }
  if (x1 == x0) x1 = x0 + 1
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"12\">\n", width, height, width, height
  print "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>"
  text(width / 2, 20, title, "text-anchor=\"middle\" font-size=\"14\"")
  if (logY) { for (p = int(log(y0) / log(10)) - 1; p < 12; ++p) for (m = 1; m <= 5; m += (m == 1 ? 1 : 3)) { v = m * 10 ^ p; if (v >= y0 && v <= y1) yTick(v) } }
  else { d = step(y1 - y0, 6); for (v = int(y0 / d) * d; v <= y1; v += d) yTick(v) }
  if (names) for (i = 1; i <= names; ++i) xTick(i - 1, word[i])
  else { d = step(x1 - x0, 8); for (v = int(x0 / d) * d; v <= x1 + d / 1000; v += d) if (v >= x0) xTick(v, sprintf("%g", v)) }
  printf "<path d=\"M%d %dV%dH%d\" fill=\"none\" stroke=\"black\"/>\n", left, top, height - bottom, width - right
  text((left + width - right) / 2, height - 12, xLabel, "text-anchor=\"middle\"")
  printf "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\">%s</text>\n", (top + height - bottom) / 2, yLabel
  for (s = 1; s <= series; ++s) {
    dashes = name[s] ~ /^thesis/ ? " stroke-dasharray=\"5 4\"" : ""
    of = name[s]; sub(/^thesis, /, "", of) # has the colour of ours
    ink = colour[((of in number ? number[of] : s) - 1) % 8 + 1]; shift = marks ? 9 * (s - (series + 1) / 2) : 0
    if (!marks) {
      printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"%s points=\"", ink, dashes
      for (k = 1; k <= count[s]; ++k) printf "%.1f,%.1f ", px(x[s, k]), py(y[s, k])
      print "\"/>"
    }
    for (k = 1; k <= count[s] && (marks || count[s] < 40); ++k) {
      if (barred[s, k]) printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"2\"/>\n", px(x[s, k]) + shift, px(x[s, k]) + shift, py(low[s, k]), py(high[s, k]), ink
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", px(x[s, k]) + shift, py(y[s, k]), ink
    }
    printf "<line x1=\"%d\" x2=\"%d\" y1=\"%d\" y2=\"%d\" stroke=\"%s\" stroke-width=\"2\"%s/>\n", left + 12, left + 36, top + 16 * s - 4, top + 16 * s - 4, ink, dashes
    text(left + 42, top + 16 * s, name[s], "")
  }
  print "</svg>"
}
