// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneFile_h
#define LittoralSceneFile_h

#include "ReplacedFile.h"
#include "Scene.h"

#include <functional>
#include <string>

namespace littoral
{

/// Largest GLB file, whose length has 32 bits [bytes].
inline constexpr double MaximumSceneFile = 4294967295.0;

/// Callback with the part that is done, 0 to 1; returns whether to go on.
using SceneProgress = std::function<bool(double)>;

/// Throws InvalidInput if a text is no object of JSON.
void RequireExtras(const std::string& json);

/**
 * Writes a scene as glTF 2.0 binary. A file that is there already stays as it is unless the new one is whole. The bytes
 * depend on the scene alone.
 */
FileOutcome WriteScene(const std::string& path, const Scene& scene, const SceneProgress& progress);

/// The bytes of the file of a scene.
std::string SceneBytes(const Scene& scene);

}

#endif
