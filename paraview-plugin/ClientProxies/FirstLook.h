// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFirstLook_h
#define LittoralFirstLook_h

class vtkPVDataInformation;
class vtkSMProxy;

namespace littoral
{

/// Takes a point array as colors, as they are: one that the data have, or one that is not known yet, since it is made
/// for the picture.
void ColorDirectly(vtkSMProxy* representation, const char* array, bool isKnown);

/// Shades with the normals of a point array, which ParaView leaves aside.
void ShadeSmoothly(vtkSMProxy* representation, const char* array);

/// Lights a surface whose colors have the sky in them: a share of ambient light, the rest scattered, and glitter.
void ShadeAsWater(vtkSMProxy* representation, double ambient);

/// Light of the sky and of the ground from everywhere, added to that of the lights: no leaf is black.
void ShadeUnderSky(vtkSMProxy* representation, double share);

/// Colors by a point array. A color map that is still ParaView's own becomes a preset, unless `preset` is null.
void ColorByArray(vtkSMProxy* representation, const char* array, const char* preset);

/// Shows the legend of a representation, in a dark color that can be read in front of a pale sky.
void ShowDarkLegend(vtkSMProxy* representation, vtkSMProxy* view, const char* title);

/// Radius of the largest particle in a view of all of the data, at least [diagonals].
constexpr double MinimumSprite = 0.006;

/// Particles, points with the arrays ParticleId and Radius, as lit spheres. Radii are enlarged where the largest would
/// be below `smallest` [diagonals of the data].
bool AreParticles(vtkPVDataInformation* data);
void ShowAsSprites(vtkSMProxy* representation, vtkPVDataInformation* data, double smallest);

/// Lines of a width [pixels], in a color unless it is null.
void DrawLines(vtkSMProxy* representation, double width, const double* color);

/// Points as round dots of a color and a size [pixels], which is the same in a survey of any extent and near the eye.
void ShowAsDots(vtkSMProxy* representation, double size, const double color[3]);

/**
 * An image of extinction s [1/m] as a volume. Opacity is 1 - exp(-F s U) over the unit distance U, so that light is
 * absorbed as in F times as much fog; F is 1 where the fog is dense enough to be seen, else above. A transfer function
 * that is no longer ParaView's own stays. Fog has the color, darker where it is denser, or that of water where it is
 * null.
 */
void ShowAsFog(vtkSMProxy* representation, vtkPVDataInformation* data, const char* array, const double* color);

}

#endif
