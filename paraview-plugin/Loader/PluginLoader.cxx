// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// What ParaView opens as the plugin. ParaView does not ask a plugin which version it was built for: a wrong one ends in
// the dynamic linker's words, and where its libraries are installed too, in two ParaViews in one process. This library
// links with nothing of ParaView, compares the versions, and only then opens the plugin itself, which lies beside it.

#include <cstdio>
#include <dlfcn.h>
#include <link.h>
#include <string>

namespace
{
struct LoadedSymbol
{
  const char* library; // part of the library's file name
  const char* symbol;
  void* address;
};

// Looks in one loaded library; programs that load ParaView as a Python module keep its symbols to themselves.
int VisitLibrary(dl_phdr_info* info, size_t, void* data)
{
  auto* wanted = static_cast<LoadedSymbol*>(data);
  if (std::string(info->dlpi_name).find(wanted->library) == std::string::npos)
  {
    return 0;
  }
  if (void* library = dlopen(info->dlpi_name, RTLD_LAZY | RTLD_NOLOAD))
  {
    wanted->address = dlsym(library, wanted->symbol);
    dlclose(library);
  }
  return wanted->address ? 1 : 0;
}

template <typename Function>
Function FindLoaded(const char* library, const char* symbol)
{
  LoadedSymbol wanted{ library, symbol, nullptr };
  dl_iterate_phdr(VisitLibrary, &wanted);
  return reinterpret_cast<Function>(wanted.address);
}

// vtkSMProxyManager::GetParaViewSourceVersion() says "paraview version 5.11.0"; empty if it is not there.
std::string RunningVersion()
{
  const auto version =
    FindLoaded<const char* (*)()>("libvtkRemotingServerManager", "_ZN17vtkSMProxyManager24GetParaViewSourceVersionEv");
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

// To ParaView's messages by vtkOutputWindowDisplayErrorText(const char*), else to the terminal.
void Say(const std::string& message)
{
  const auto display = FindLoaded<void (*)(const char*)>("libvtkCommonCore", "_Z31vtkOutputWindowDisplayErrorTextPKc");
  if (display)
  {
    display((message + "\n").c_str());
  }
  else
  {
    std::fprintf(stderr, "%s\n", message.c_str());
  }
}

std::string OwnPath()
{
  Dl_info info;
  return dladdr(reinterpret_cast<void*>(&OwnPath), &info) ? info.dli_fname : "";
}

void* LoadPlugin()
{
  const std::string running = RunningVersion();
  if (!running.empty() && !SameMinorVersion(running))
  {
    Say("Littoral " LITTORAL_VERSION " was built for ParaView " LITTORAL_PARAVIEW_VERSION ", and this is ParaView " +
      running + ". The plugin was not loaded; it takes one that was built for this version.");
    return nullptr;
  }
  void* plugin = dlopen((OwnPath() + LITTORAL_PLUGIN_SUFFIX).c_str(), RTLD_LAZY);
  if (!plugin)
  {
    Say(std::string("Littoral " LITTORAL_VERSION " was not loaded: ") + dlerror());
    return nullptr;
  }
  const auto instance = reinterpret_cast<void* (*)()>(dlsym(plugin, "pv_plugin_instance_Littoral"));
  return instance ? instance() : nullptr;
}
}

extern "C" __attribute__((visibility("default"))) void* pv_plugin_instance()
{
  static void* instance = LoadPlugin();
  return instance;
}
