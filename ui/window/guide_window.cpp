#include "ui/window/guide_window.h"

#include <QDesktopServices>
#include <QDir>
#include <QTextBrowser>
#include <QToolButton>

#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

// Pictures are as wide as the text at most.
class PageBrowser : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return resource;
    QImage image = resource.value<QImage>();
    if (image.isNull()) image = QImage(source().resolved(name).toLocalFile());
    const int most = viewport()->width() - 40;
    return image.width() > most ? image.scaledToWidth(most, Qt::SmoothTransformation) : image;
  }
};

}  // namespace

GuideWindow::GuideWindow(const QString& folder, QWidget* parent)
    : QDialog(parent), browser_(new PageBrowser(this)) {
  setWindowTitle(tr("Guide"));
  browser_->setOpenLinks(false);
  connect(browser_, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
  const auto button = [this](const char* sign, const QString& name) {
    auto* made = textButton(sign, {}, this);
    nameAndTip(made, name);
    return made;
  };
  QToolButton *back = button("←", tr("Back")), *forward = button("→", tr("Forward")),
              *contents = button("⌂", tr("Contents"));
  connect(back, &QToolButton::clicked, browser_, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, browser_, &QTextBrowser::forward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  const QUrl first = QUrl::fromLocalFile(QDir(folder).filePath("index.md"));
  connect(contents, &QToolButton::clicked, this, [this, first] { follow(first); });
  layOut(this, columnOf({lineOf({back, forward, contents, Cell::room()}), browser_}));
  resize(820, 760);
  follow(first);
  back->setEnabled(false);
  forward->setEnabled(false);
}

// Pages open here, addresses in the user's browser.
void GuideWindow::follow(const QUrl& link) {
  const QUrl target = browser_->source().resolved(link);
  const bool isFile = target.isLocalFile();
  if (isFile && target.path() == browser_->source().path()) {
    browser_->scrollToAnchor(target.fragment());
  } else if (isFile && target.path().endsWith(".md")) {
    browser_->setSource(target, QTextDocument::MarkdownResource);
  } else {
    QDesktopServices::openUrl(target);
  }
}

}  // namespace isolux::ui
