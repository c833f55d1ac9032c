// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImpostorMapper
 * @brief   draw a plant many times by pictures of it, with the light of the moment
 *
 * Input: vtkPolyData, a point for each instance, with the optional point arrays `Rotation` (quaternion w, x, y, z),
 * `Scale` (one value, or x, y and z, of which x and z count) and `Tint` (factors of red, green and blue), as from
 * vtkPlantScatterFilter with OutputForm Instances, and `Fades` (0 or 1), see FadeRange. An instance is the plant
 * scaled, rotated and moved to the point.
 *
 * The plant is made of actors that are not in the renderer, see AddPart(). Before it is drawn first, and when a part
 * changed, its pictures are taken from the directions of an octahedron's grid: albedo and coverage, normal,
 * transmittance and depth. Each instance is one square with what the three pictures show that are nearest to the
 * direction of the eye, each moved by its depths. So vtkLandscapePass lights instances as it does the plant itself, at
 * any hour, and they cast shadows; without the pass the lights of the renderer do. It is meant for plants that are
 * farther away than some of their heights.
 *
 * Parts that let light through (vtkLandscapePass::TRANSMITTANCE) have the tint, others not. The graphics' memory of the
 * pictures is GetAtlasBytes().
 */
#ifndef vtkImpostorMapper_h
#define vtkImpostorMapper_h

#include "LittoralRenderingModule.h" // for export macro
#include "vtkPolyDataMapper.h"

#include <memory> // for private members

class vtkActor;

class LITTORALRENDERING_EXPORT vtkImpostorMapper : public vtkPolyDataMapper
{
public:
  static vtkImpostorMapper* New();
  vtkTypeMacro(vtkImpostorMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Actors of the plant, in its coordinates and each with a vtkPolyDataMapper; translucent textures cut them out, for
   * which they need ForceOpaqueOn().
   */
  void AddPart(vtkActor* part);
  void RemoveAllParts();
  int GetNumberOfParts();
  vtkActor* GetPart(int part);
  ///@}

  ///@{
  /** Pictures along a side of the grid, 3 to 33; an even number becomes the next one. Default 13. */
  void SetFrames(int frames);
  vtkGetMacro(Frames, int);
  ///@}
  ///@{
  /** Texels along a side of a picture, 16 to 256; no power of 2 becomes the one below. Default 64. */
  void SetFrameSize(int texels);
  vtkGetMacro(FrameSize, int);
  ///@}

  ///@{
  /**
   * Distances from the eye between which instances whose array `Fades` is 1 appear, by a pattern of pixels, so that
   * what is in the other ones can disappear [m], not decreasing; default 0 0. In parallel projection they are not
   * there.
   */
  vtkSetVector2Macro(FadeRange, double);
  vtkGetVector2Macro(FadeRange, double);
  ///@}

  /** Graphics memory of the pictures [bytes]: 9 (Frames FrameSize)^2 (1 + 1/4 + 1/16 + ...). */
  vtkTypeInt64 GetAtlasBytes();
  /** How often the pictures were taken. */
  vtkGetMacro(TimesTaken, int);

  vtkMTimeType GetMTime() override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkImpostorMapper();
  ~vtkImpostorMapper() override;

  void ComputeBounds() override;

private:
  vtkImpostorMapper(const vtkImpostorMapper&) = delete;
  void operator=(const vtkImpostorMapper&) = delete;

  void UpdateInstances();
  void UpdateAtlas(vtkRenderer* renderer);

  struct Internals;
  std::unique_ptr<Internals> Own;
  int Frames;
  int FrameSize;
  double FadeRange[2];
  int TimesTaken = 0;
};

#endif
