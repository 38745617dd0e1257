/// Plug-in entry: a plain C struct that is checked before any C++ of the library is called.
#pragma once
#include <dynamy/core/version.hpp>
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy {

/// Number of the binary interface; raised with every incompatible change of a public header.
inline constexpr int kPluginAbi = 5;

struct PluginInfo {
  int abi;
  const char* frameworkVersion;
  int eigenWorld, eigenMajor, eigenMinor;
  int eigenMaxAlignBytes;
  const char* compiler;         ///< "gcc 12.2", "clang 16.0"
  const char* standardLibrary;  ///< "libstdc++ cxx11-abi=1"
  const char* name;
  const char* version;
  void (*registerElements)(Registry&);
};

/// Versions that this translation unit was compiled with; `name`, `version` and `registerElements`
/// are empty.
PluginInfo frameworkFingerprint();

}  // namespace dynamy

#if defined(__clang__)
#define DYNAMY_COMPILER_TEXT "clang " __clang_version__
#else
#define DYNAMY_COMPILER_TEXT "gcc " __VERSION__
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI) && _GLIBCXX_USE_CXX11_ABI
#define DYNAMY_STANDARD_LIBRARY_TEXT "libstdc++, cxx11 abi"
#elif defined(_GLIBCXX_USE_CXX11_ABI)
#define DYNAMY_STANDARD_LIBRARY_TEXT "libstdc++, old abi"
#else
#define DYNAMY_STANDARD_LIBRARY_TEXT "libc++"
#endif

/// Makes a shared library a plug-in: DYNAMY_PLUGIN("name", "1.0.0", registerElements)
#define DYNAMY_PLUGIN(pluginName, pluginVersion, registerFunction)                           \
  extern "C" __attribute__((visibility("default"))) const dynamy::PluginInfo*                \
  dynamy_plugin_info() {                                                                     \
    static const dynamy::PluginInfo info{dynamy::kPluginAbi,   dynamy::kVersionText,         \
                                         EIGEN_WORLD_VERSION,  EIGEN_MAJOR_VERSION,          \
                                         EIGEN_MINOR_VERSION,  EIGEN_MAX_ALIGN_BYTES,        \
                                         DYNAMY_COMPILER_TEXT, DYNAMY_STANDARD_LIBRARY_TEXT, \
                                         pluginName,           pluginVersion,                \
                                         registerFunction};                                  \
    return &info;                                                                            \
  }
