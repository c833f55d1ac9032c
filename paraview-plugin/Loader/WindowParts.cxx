// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Library that the loader opens in a process with Qt: it puts the macros of the plugin into ParaView's menu, which looks
// for macros in the user's folder and beside the program alone, and the pages of the plugin into ParaView's help, where
// ParaView's build does not do so. It links with Qt's core; what is ParaView's is found by its name.

#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QMetaObject>
#include <QTimer>
#include <QVariant>

#include <dlfcn.h>

namespace
{
/// pqApplicationCore::instance() of the window; null in another program.
QObject* FindApplication()
{
  const auto core = reinterpret_cast<QObject* (*)()>(dlsym(RTLD_DEFAULT, "_ZN17pqApplicationCore8instanceEv"));
  return core ? core() : nullptr;
}

/// Calls pqApplicationCore's helpEngine() and registerDocumentation(const QString&) for a file, if it is there. Qt 6 makes
/// a help engine that is read-only, unlike Qt 5: it is set up anew before, by QHelpEngineCore::setupData().
void AddHelp(const QString& file)
{
  QObject* application = FindApplication();
  const auto engine =
    reinterpret_cast<QObject* (*)(QObject*)>(dlsym(RTLD_DEFAULT, "_ZN17pqApplicationCore10helpEngineEv"));
  const auto setUp = reinterpret_cast<bool (*)(QObject*)>(dlsym(RTLD_DEFAULT, "_ZN15QHelpEngineCore9setupDataEv"));
  const auto add = reinterpret_cast<void (*)(QObject*, const QString&)>(
    dlsym(RTLD_DEFAULT, "_ZN17pqApplicationCore21registerDocumentationERK7QString"));
  if (application && engine && setUp && add && QFileInfo::exists(file))
  {
    QObject* help = engine(application);
    if (help && help->setProperty("readOnly", false) && setUp(help))
    {
      add(application, file);
    }
  }
}

/// pqPythonMacroSupervisor of the window; null if there is none, as in a ParaView without Python.
QObject* FindSupervisor()
{
  QObject* application = FindApplication();
  for (QObject* one : application ? application->findChildren<QObject*>() : QList<QObject*>())
  {
    if (one->inherits("pqPythonMacroSupervisor"))
    {
      return one;
    }
  }
  return nullptr;
}

/// Macros of a folder in ParaView's menu. ParaView takes all out when its list has changed, and reads its folders.
class Macros : public QObject
{
public:
  explicit Macros(const QString& folder)
    : QObject(QCoreApplication::instance())
    , Folder(folder)
  {
    this->AddLater();
  }

  bool eventFilter(QObject* supervisor, QEvent* event) override
  {
    if (event->type() == QEvent::ChildRemoved)
    {
      this->AddLater();
    }
    return QObject::eventFilter(supervisor, event);
  }

private:
  void AddLater()
  {
    if (!this->IsWaiting)
    {
      this->IsWaiting = true;
      QTimer::singleShot(0, this, [this] { this->Add(); });
    }
  }

  void Add()
  {
    QObject* supervisor = FindSupervisor();
    if (supervisor)
    {
      supervisor->removeEventFilter(this);
      for (const QFileInfo& file : QDir(this->Folder).entryInfoList({ "*.py" }, QDir::Files, QDir::Name))
      {
        QMetaObject::invokeMethod(supervisor, "addMacro", Q_ARG(QString, file.absoluteFilePath()));
      }
      supervisor->installEventFilter(this);
    }
    this->IsWaiting = false;
  }

  QString Folder;
  bool IsWaiting = false;
};
}

extern "C" __attribute__((visibility("default"))) void littoral_add_to_window(const char* folder)
{
  if (QCoreApplication::instance())
  {
    const QDir ours(QString::fromLocal8Bit(folder));
    new Macros(ours.filePath("Macros")); // the application deletes it
    QTimer::singleShot(0, QCoreApplication::instance(), [ours] { AddHelp(ours.filePath("Littoral.qch")); });
  }
}
