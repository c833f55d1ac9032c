// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Library that ParaView opens as the plugin. ParaView does not ask a plugin which version it was built for: a wrong one
// ends in the dynamic linker's words, and where its libraries are installed too, in two ParaViews in one process. This
// library links with nothing of ParaView, compares the versions, and only then opens the plugin itself, which lies
// beside it.

#include <cstdio>
#include <dlfcn.h>
#include <link.h>
#include <string>

namespace
{
struct LoadedLibrary
{
  const char* part; // of its file name
  std::string path;
};

int VisitLibrary(dl_phdr_info* info, size_t, void* data)
{
  auto* wanted = static_cast<LoadedLibrary*>(data);
  const std::string path = info->dlpi_name;
  if (path.find(wanted->part) == std::string::npos)
  {
    return 0;
  }
  wanted->path = path;
  return 1;
}

// The path of a library that this process has loaded; empty if it has not.
std::string FindLibrary(const char* part)
{
  LoadedLibrary wanted{ part, {} };
  dl_iterate_phdr(VisitLibrary, &wanted);
  return wanted.path;
}

// Function of a library by its name, since programs that load ParaView as a Python module keep its symbols to
// themselves.
template <typename Function>
Function FindFunction(const char* part, const char* symbol)
{
  const std::string path = FindLibrary(part);
  void* library = path.empty() ? nullptr : dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  void* address = library ? dlsym(library, symbol) : nullptr;
  if (library)
  {
    dlclose(library); // what had it loaded keeps it
  }
  return reinterpret_cast<Function>(address);
}

// vtkSMProxyManager::GetParaViewSourceVersion() says "paraview version 5.11.0"; empty if it is not there.
std::string RunningVersion()
{
  const auto version = FindFunction<const char* (*)()>(
    "libvtkRemotingServerManager", "_ZN17vtkSMProxyManager24GetParaViewSourceVersionEv");
  const std::string text = version ? version() : "";
  const auto digit = text.find_first_of("0123456789");
  return digit == std::string::npos ? std::string() : text.substr(digit);
}

bool SameMinorVersion(const std::string& version)
{
  const std::string built = LITTORAL_PARAVIEW_VERSION;
  return version.compare(0, built.size(), built) == 0 &&
    (version.size() == built.size() || version[built.size()] == '.');
}

// Reports to ParaView's messages by vtkOutputWindowDisplayErrorText(const char*), else to the terminal.
void* Refuse(const std::string& reason)
{
  const std::string message = "Littoral " LITTORAL_VERSION " was not loaded: " + reason + "\n";
  const auto display =
    FindFunction<void (*)(const char*)>("libvtkCommonCore", "_Z31vtkOutputWindowDisplayErrorTextPKc");
  if (display)
  {
    display(message.c_str());
  }
  else
  {
    static_cast<void>(std::fputs(message.c_str(), stderr));
  }
  return nullptr;
}

std::string OwnPath()
{
  Dl_info info;
  return dladdr(reinterpret_cast<void*>(&OwnPath), &info) ? info.dli_fname : "";
}

// Icons, which are resources of Qt, macros and help need Qt. Not lazily: where Qt's symbols are not those of the process,
// there are none.
void LoadWindowParts()
{
  if (FindLibrary("libQt5Core").empty() && FindLibrary("libQt6Core").empty())
  {
    return;
  }
  const std::string path = OwnPath();
  dlopen((path + ".icons").c_str(), RTLD_NOW);
  void* window = dlopen((path + ".window").c_str(), RTLD_NOW);
  const auto add = window ? reinterpret_cast<void (*)(const char*)>(dlsym(window, "littoral_add_to_window")) : nullptr;
  if (add)
  {
    add(path.substr(0, path.rfind('/')).c_str());
  }
}

void* LoadPlugin()
{
  const std::string running = RunningVersion();
  if (!running.empty() && !SameMinorVersion(running))
  {
    return Refuse("it was built for ParaView " LITTORAL_PARAVIEW_VERSION ", and this is ParaView " + running + ".");
  }
  const std::string other = FindLibrary("/Littoral.so.pv");
  if (!other.empty())
  {
    return Refuse("there is another one, " + other + ".");
  }
  void* plugin = dlopen((OwnPath() + LITTORAL_PLUGIN_SUFFIX).c_str(), RTLD_LAZY);
  if (!plugin)
  {
    return Refuse(dlerror());
  }
  LoadWindowParts();
  const auto instance = reinterpret_cast<void* (*)()>(dlsym(plugin, "pv_plugin_instance_Littoral"));
  return instance ? instance() : Refuse("its library is not whole.");
}
}

// ParaView asks again where it is told to load the plugin again; a refusal is said each time.
extern "C" __attribute__((visibility("default"))) void* pv_plugin_instance()
{
  static void* instance = nullptr;
  if (!instance)
  {
    instance = LoadPlugin();
  }
  return instance;
}
