// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScene_h
#define LittoralScene_h

#include <set>

class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkSMViewProxy;

namespace littoral
{

/**
 * A pipeline that begins with a source, described by an element of the source's definition:
 *
 *     <Scene eye="40 -30 62" target="230 260 0" light="land">
 *       <Set property="Size" values="400 400" />
 *       <Source name="Hills" type="TurningBandsTerrain"><Set property="Range" values="400" /></Source>
 *       <Filter name="Ground" type="TerrainLevelOfDetail">
 *         <Connect property="Input" to="Hills" />
 *         <NaturalDisplay own-levels="1" />
 *       </Filter>
 *     </Scene>
 *
 * The attributes are those of NaturalDisplay, for the view. The source has the values of Set from the start. The rest
 * are ordinary sources and filters, made when the source is first shown; `to` names one before it, or the source by the
 * name of its type. Those with a NaturalDisplay are shown, in that way, which goes before the hint of their type; its
 * attribute `port` numbers the output, 0 by default.
 * A part with an element Display is shown, with the values that its display has there:
 *
 *     <Source name="Light" type="LandscapeLight">
 *       <Display><Set property="SunElevation" values="20" /></Display>
 *     </Source>
 *
 * A Landscape Light is made only in a view that takes one, see TakesLandscapeLight.
 *
 * With `depth` the heights of the camera, and the value of each part's Set that its attribute `of-depth` numbers, are
 * those for that WaterDepth of the source [m], and in proportion to it.
 */

/// All that a filter is made of, from its inputs up to the sources.
std::set<vtkSMProxy*> UpstreamOf(vtkSMProxy* filter);

/// Sets the properties of a proxy to the values of a description.
void SetValues(vtkSMProxy* proxy, vtkPVXMLElement* description);

/// The parts of a scene go along with the bed: brings what is of a depth of water to `ratio` times as deep.
void ScaleDepths(vtkSMSourceProxy* source, vtkPVXMLElement* scene, double ratio);

/// Whether no filter has a source as input.
bool IsLastOfPipeline(vtkSMSourceProxy* source);

/// Registers the parts behind a source, shows them in a view, and gives the animation the frames of a film if it still
/// has ParaView's, and new films the rate of their times.
void MakeScene(vtkSMSourceProxy* source, vtkPVXMLElement* scene, vtkSMViewProxy* view);

}

#endif
