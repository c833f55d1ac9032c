// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPartsInTurn_h
#define LittoralPartsInTurn_h

#include "OpenGL.h"

namespace littoral
{

/// Parts of what a processor draws, each of them sent while the one before is still drawn, but not more at a time:
/// llvmpipe keeps all triangles that are still to be drawn, at up to a kilobyte each.
class PartsInTurn
{
public:
  PartsInTurn() = default;
  ~PartsInTurn() { this->Wait(); }

  /// Ends a part, which was sent; waits for the part before.
  void End()
  {
    GLsync sent = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    this->Wait();
    this->Before = sent;
  }

private:
  PartsInTurn(const PartsInTurn&) = delete;
  void operator=(const PartsInTurn&) = delete;

  void Wait()
  {
    constexpr GLuint64 second = 1000000000; // ns
    while (this->Before && glClientWaitSync(this->Before, GL_SYNC_FLUSH_COMMANDS_BIT, second) == GL_TIMEOUT_EXPIRED)
    {
    }
    glDeleteSync(this->Before); // nothing for none
    this->Before = nullptr;
  }

  GLsync Before = nullptr;
};

}

#endif
