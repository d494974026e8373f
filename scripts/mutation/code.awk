# Reads C++ a line at a time: codeOf(line) is the line with its comments and texts as spaces, so that columns stay.
# `comment` says whether a comment is open; it is set to 0 where a file begins.
function blank(text,   spaces) { spaces = sprintf("%" length(text) "s", ""); return spaces }
function codeOf(line,   code, at, c, quote) {
  code = ""
  for (at = 1; at <= length(line); ++at) {
    c = substr(line, at, 1)
    if (quote != "") {
      if (c == "\\") { code = code "  "; ++at; continue }
      if (c == quote) quote = ""
      code = code " "
    } else if (comment) {
      if (substr(line, at, 2) == "*/") { comment = 0; code = code "  "; ++at } else code = code " "
    } else if (substr(line, at, 2) == "/*") { comment = 1; code = code "  "; ++at
    } else if (substr(line, at, 2) == "//") { code = code blank(substr(line, at)); break
    } else if (c == "\"" || (c == "'" && substr(line, at - 1, 1) !~ /[0-9]/)) { quote = c; code = code " "
    } else code = code c
  }
  return code
}
