// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentAlgorithm
 * @brief   base of the filters whose output depends on the view: levels of detail and culling
 *
 * A subclass asks GetView() for the view of the request. Two ways set it: by numbers, or by Follow(), which takes the
 * camera of a renderer before each of its pictures:
 *
 *     filter->Follow(renderer);
 *
 * In ParaView the property FollowCamera of the proxies does that.
 *
 * With a tolerance above 0 the view is rounded, and the filter works again only when the rounded view has changed; what
 * it keeps is then chosen for all views that round to the same. The output is a function of the view of the moment,
 * never of those before.
 */
#ifndef vtkViewDependentAlgorithm_h
#define vtkViewDependentAlgorithm_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkWeakPointer.h" // for the renderer

class vtkCamera;
class vtkRenderer;

namespace littoral
{
struct View;
}

class LITTORALFILTERS_EXPORT vtkViewDependentAlgorithm : public vtkMultiBlockDataSetAlgorithm
{
public:
  vtkTypeMacro(vtkViewDependentAlgorithm, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where the eye is [m]; in a parallel projection a place on the plane from which rays go. Default 0 -100 20.
  void SetViewPoint(double x, double y, double z);
  void SetViewPoint(const double point[3]) { this->SetViewPoint(point[0], point[1], point[2]); }
  vtkGetVector3Macro(ViewPoint, double);
  ///@}

  ///@{
  /// Where it looks; any length but 0. Default 0 1 0.
  void SetViewDirection(double x, double y, double z);
  void SetViewDirection(const double d[3]) { this->SetViewDirection(d[0], d[1], d[2]); }
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /// What is up in the picture; any length but 0, not along ViewDirection. Default 0 0 1.
  void SetViewUp(double x, double y, double z);
  void SetViewUp(const double up[3]) { this->SetViewUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /// From the lower to the upper edge of the picture [degrees], above 0 and below 180. In a parallel projection of
  /// effect on levels of detail alone, see ParallelScale. Default 30.
  void SetViewAngle(double angle);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /// Whether rays are parallel, and not from the eye. Default off.
  void SetParallelProjection(bool parallel);
  vtkGetMacro(ParallelProjection, bool);
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  ///@{
  /// Half the height of what a parallel projection shows [m], positive. Levels of detail go by it, and not by
  /// distances: all places have the level of the distance at which a perspective of ViewAngle shows as much,
  /// ParallelScale / tan (ViewAngle / 2). Default 100.
  void SetParallelScale(double scale);
  vtkGetMacro(ParallelScale, double);
  ///@}

  ///@{
  /// Width of the picture by its height, positive. Default 16 / 9.
  void SetAspectRatio(double ratio);
  vtkGetMacro(AspectRatio, double);
  ///@}

  ///@{
  /// Height of the picture [pixels], positive; of effect where errors on the screen decide. Default 1080.
  void SetViewHeight(double height);
  vtkGetMacro(ViewHeight, double);
  ///@}

  /// Takes ViewPoint, ViewDirection, ViewUp, ViewAngle, ParallelProjection and ParallelScale from a camera, for a
  /// picture of AspectRatio. Off-axis projections, shears and a window whose center is elsewhere are not taken.
  void SetCamera(vtkCamera* camera);

  /// Takes camera, aspect ratio and height of a renderer before each of its pictures; null ends that.
  void Follow(vtkRenderer* renderer);

  ///@{
  /// Distances [m] from the eye (see ParallelScale for none) to which the first and the second level of detail are
  /// shown; beyond is the third. Not negative, the second not below the first. Defaults: those of the subclass.
  vtkSetMacro(NearDistance, double);
  vtkGetMacro(NearDistance, double);
  vtkSetMacro(FarDistance, double);
  vtkGetMacro(FarDistance, double);
  ///@}

  ///@{
  /// How far the eye moves before the filter works again [m], not negative. Default 0: at each move.
  vtkSetMacro(MoveTolerance, double);
  vtkGetMacro(MoveTolerance, double);
  ///@}

  ///@{
  /// How far the view turns before the filter works again [degrees], 0 to 10. Default 0: at each turn.
  vtkSetMacro(TurnTolerance, double);
  vtkGetMacro(TurnTolerance, double);
  ///@}

protected:
  vtkViewDependentAlgorithm();
  ~vtkViewDependentAlgorithm() override;

  /// The view in full, rounded by the tolerances. False, with an error message, if a number of it is bad.
  bool GetView(littoral::View& view);

  double ViewPoint[3];
  double ViewDirection[3];
  double ViewUp[3];
  double ViewAngle;
  bool ParallelProjection;
  double ParallelScale;
  double AspectRatio;
  double ViewHeight;
  double NearDistance;
  double FarDistance;
  double MoveTolerance;
  double TurnTolerance;

private:
  vtkViewDependentAlgorithm(const vtkViewDependentAlgorithm&) = delete;
  void operator=(const vtkViewDependentAlgorithm&) = delete;

  littoral::View UnroundedView() const;
  littoral::View RoundedView() const;
  template <typename Change>
  void ChangeView(const Change& change);
  void Take(const littoral::View& view);
  void TakeRenderer();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
};

#endif
