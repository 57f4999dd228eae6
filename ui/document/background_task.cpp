#include "ui/document/background_task.h"

#include <memory>
#include <utility>

#include <QPointer>

namespace isolux::ui {

std::function<void()> posted(QObject* receiver, std::function<void()> call) {
  // Posted to an object that lives as long as the function: the receiver may be destroyed at any time.
  const std::shared_ptr<QObject> relay(new QObject, [](QObject* object) { object->deleteLater(); });
  return [relay, here = QPointer<QObject>(receiver), call = std::move(call)] {
    QMetaObject::invokeMethod(
        relay.get(),
        [here, call] {
          if (here) call();
        },
        Qt::QueuedConnection);
  };
}

}  // namespace isolux::ui
