// The language of the window: the user's choice, or what the system speaks.
#pragma once

#include <QString>
#include <QStringList>

namespace isolux::ui {

enum class Language { system, english, german };

// What was kept for this user; system where nothing was, or nothing that is known.
Language savedLanguage();
void keepLanguage(Language language);

// Of the system's languages ("de-AT", "en", best first) the first that Isolux speaks; English where it speaks
// none.
Language spokenOf(const QStringList& languages);

// Puts the translations of Isolux and of Qt itself into the application, in place of those that were there.
// What is made before keeps its texts: call it before the first window. Where Qt's own are not installed, its
// buttons are English.
void setLanguage(Language language);

}  // namespace isolux::ui
