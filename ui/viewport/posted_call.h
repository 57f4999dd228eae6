// Has other threads wake the window's thread, instead of its polling them.
#pragma once

#include <functional>

#include <QObject>

namespace isolux::ui {

// Returns a function that any thread may call, at any time: `call` then runs soon on the window's thread, if
// `receiver` still exists. Requires to be called on the window's thread.
std::function<void()> posted(QObject* receiver, std::function<void()> call);

}  // namespace isolux::ui
