// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSharedKey_h
#define LittoralSupportSharedKey_h

// Keys of information of our own. Private: never installed, never wrapped.

#include "vtkInformationKeyLookup.h"

namespace littoral
{

/// A key by its name. The libraries of sources and of filters each have a copy of what asks for it, but one key.
template <typename Key>
Key* SharedKey(const char* name)
{
  vtkInformationKey* key = vtkInformationKeyLookup::Find(name, "littoral");
  return key ? static_cast<Key*>(key) : Key::MakeKey(name, "littoral");
}

}

#endif
