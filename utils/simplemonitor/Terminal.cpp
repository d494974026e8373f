#include "Terminal.h"

#include <langinfo.h>
#include <ncurses.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace plumbline::simplemonitor {

using watch::Ink;

namespace {

struct Look {
  Ink ink;
  short foreground, background;
  attr_t attributes;
};
constexpr short terminals = -1;  ///< the terminal's own colour
constexpr Look looks[] = {
    {Ink::plain, terminals, terminals, A_NORMAL},       {Ink::line, COLOR_GREEN, terminals, A_NORMAL},
    {Ink::left, COLOR_WHITE, COLOR_BLUE, A_BOLD},       {Ink::right, COLOR_WHITE, COLOR_RED, A_BOLD},
    {Ink::nobody, COLOR_BLACK, COLOR_CYAN, A_NORMAL},   {Ink::ball, COLOR_YELLOW, terminals, A_BOLD},
    {Ink::problem, COLOR_BLACK, COLOR_YELLOW, A_NORMAL}};

attr_t attributesOf(Ink ink, bool colours) {
  const auto pair = static_cast<int>(ink);
  if (!colours) return ink == Ink::problem ? A_REVERSE : ink == Ink::ball ? A_BOLD : A_NORMAL;
  return static_cast<attr_t>(COLOR_PAIR(pair + 1)) | looks[pair].attributes;
}

}  // namespace

bool localeIsUnicode() { return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0; }

Terminal::Terminal(bool asciiOnly) {
  if (!isatty(STDOUT_FILENO))
    throw std::runtime_error("standard output is no terminal; --once prints one picture as text");
  screen_ = newterm(nullptr, stdout, stdin);
  if (!screen_) {
    const char* name = std::getenv("TERM");
    throw std::runtime_error("terminal '" + std::string(name ? name : "") +
                             "' is unknown: set TERM, e.g. to xterm, or use --once");
  }
  cbreak();
  noecho();
  curs_set(0);
  nodelay(stdscr, TRUE);
  keypad(stdscr, TRUE);
  style_.unicode = !asciiOnly && localeIsUnicode();
  const char* plain = std::getenv("NO_COLOR");
  style_.colours = has_colors() && start_color() == OK && !(plain && *plain);
  if (!style_.colours) return;
  use_default_colors();
  for (const Look& look : looks)
    init_pair(static_cast<short>(static_cast<int>(look.ink) + 1), look.foreground, look.background);
}

Terminal::~Terminal() {
  endwin();
  delscreen(static_cast<SCREEN*>(screen_));
}

int Terminal::columns() const { return COLS; }
int Terminal::rows() const { return LINES; }

void Terminal::show(const watch::TextPicture& picture) {
  erase();
  for (int row = 0; row < picture.rows(); ++row) {
    int column = 0;
    while (column < picture.columns()) {  // a run of one ink
      const Ink ink = picture.at(column, row).ink;
      std::wstring run;
      const int begin = column;
      for (; column < picture.columns() && picture.at(column, row).ink == ink; ++column)
        run += static_cast<wchar_t>(picture.at(column, row).glyph);
      attrset(static_cast<int>(attributesOf(ink, style_.colours)));
      mvaddwstr(row, begin, run.c_str());
    }
  }
  attrset(A_NORMAL);
  refresh();
}

Terminal::Key Terminal::key() {
  Key found = Key::none;
  for (int pressed = 0; (pressed = getch()) != ERR;) {
    if (pressed == 'q' || pressed == 'Q' || pressed == 3) return Key::quit;
    if (pressed == KEY_RESIZE) found = Key::resized;
    if (pressed == 12) {  // Ctrl-L: draw all anew
      clearok(stdscr, TRUE);
      found = Key::redraw;
    }
  }
  return found;
}

}  // namespace plumbline::simplemonitor
