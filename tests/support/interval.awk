# The share k of n in percent with its 95 % interval (Wilson 1927).
function interval(k, n,   p, z, c, h) { p = k / n; z = 1.96; c = (p + z * z / 2 / n) / (1 + z * z / n)
  h = z / (1 + z * z / n) * sqrt(p * (1 - p) / n + z * z / 4 / n / n); return sprintf("%.0f %% (%.0f to %.0f)", 100 * p, 100 * (c - h), 100 * (c + h)) }
# Half of the 95 % interval of the mean of n values, of which s is the sum and q the sum of squares; 0 of fewer than two.
function half95(s, q, n,   v) { if (n < 2) return 0; v = (q - s ^ 2 / n) / (n - 1); return 1.96 * sqrt((v > 0 ? v : 0) / n) }
