#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

// The resources lie in a static library: the linker keeps them only when they are asked for by name.
static void initialiseTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace isolux::ui {

namespace {

constexpr auto languageKey = "language";

// Names of ISO 639, which stand in file names and settings; empty: the system's.
QString codeOf(Language language) {
  constexpr const char* codes[] = {"", "en", "de"};
  return codes[static_cast<std::size_t>(language)];
}

void install(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName("language");
  if (translator->load(file, folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

}  // namespace

Language savedLanguage() {
  const QString kept = QSettings().value(languageKey).toString();
  for (const Language language : {Language::english, Language::german})
    if (kept == codeOf(language)) return language;
  return Language::system;
}

void keepLanguage(Language language) {
  QSettings settings;
  if (language == Language::system)
    settings.remove(languageKey);
  else
    settings.setValue(languageKey, codeOf(language));
}

Language spokenOf(const QStringList& languages) {
  for (const QString& name : languages) {
    const QString code = name.section('-', 0, 0).section('_', 0, 0).toLower();
    for (const Language language : {Language::english, Language::german})
      if (code == codeOf(language)) return language;
  }
  return Language::english;
}

void setLanguage(Language language) {
  for (auto* old : QCoreApplication::instance()->findChildren<QTranslator*>("language")) {
    QCoreApplication::removeTranslator(old);
    delete old;
  }
  if (language == Language::system) language = spokenOf(QLocale::system().uiLanguages());
  if (language == Language::english) return;  // the texts in the sources
  initialiseTranslations();
  const QString code = codeOf(language);
  install("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install("isolux_" + code, ":/translations");
}

}  // namespace isolux::ui
