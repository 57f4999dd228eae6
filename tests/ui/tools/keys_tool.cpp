// Writes docs/reference/keys.md from the window's help table. Needs neither a display nor an OpenGL context.
#include <cstdio>

#include <QRegularExpression>

#include "ui/window/main_window.h"

int main() {
  static const QRegularExpression part("<h4>(.*?)</h4>|<tr><td>(.*?)</td><td>(.*?)</td></tr>");
  static const QRegularExpression bold("</?b>"), italic("</?i>");
  QString page =
      "# Mouse and keys\n\nIn the window, *Help > Mouse and keys* (`F1`) shows a table of them. Arrows, "
      "Space, **+** and "
      "**−** act on the view that\nhas the focus. Handles of lights and the environment need global "
      "illumination.\n";
  const QString html = QString::fromUtf8(isolux::ui::MainWindow::helpText());
  for (auto found = part.globalMatch(html); found.hasNext();) {
    const QRegularExpressionMatch row = found.next();
    if (row.hasCaptured(1))
      page += "\n## " + row.captured(1) + "\n\n|input|effect|\n|---|---|\n";
    else
      page += "|" + row.captured(2).replace(bold, "**") + "|" + row.captured(3).replace(italic, "*") + "|\n";
  }
  std::fputs(page.toUtf8().constData(), stdout);
}
