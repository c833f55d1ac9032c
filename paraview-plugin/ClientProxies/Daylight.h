// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDaylight_h
#define LittoralDaylight_h

class vtkSMProxy;

namespace littoral
{

/**
 * Gives a render view a background with the colors of the sky, of the sea's horizon or of water, and a sun, if it still
 * has ParaView's background and lights, all at their defaults, and has never had these. Known moods: "land", "sea",
 * "water", "murk" (water near the surface), "paper" (white, without a sun); others change nothing.
 *
 * The sun is an additional light that stands still in the scene; the light kit, dimmed, is the light of the sky. All of
 * this are properties of the view, which state files keep and the user can change.
 */
void LightView(vtkSMProxy* view, const char* mood);

/// Whether a representation is a Landscape Light.
bool IsLandscapeLight(vtkSMProxy* representation);

/// Whether a scene brings its light into a view: one that shows nothing, has no Landscape Light, and has ParaView's
/// background and lights or those of a mood.
bool TakesLandscapeLight(vtkSMProxy* view);

/// Whether a view has the mood "paper" from LightView, unchanged; another mood may follow.
bool IsMap(vtkSMProxy* view);

}

#endif
