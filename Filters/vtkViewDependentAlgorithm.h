// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentAlgorithm
 * @brief   base class of filters whose output depends on the view: levels of detail and culling
 *
 * The view is set by properties, by a camera (SetCamera()), or by Follow(), which takes the camera of a renderer before
 * each rendering:
 *
 *     filter->Follow(renderer);
 *
 * In ParaView the property FollowCamera of the proxies does the same. Subclasses get the view of a request from
 * GetView().
 *
 * With a tolerance above 0 the view is rounded, and the filter executes again only when the rounded view has changed;
 * its output then covers all views that round to the same one. The output is a function of the current view, never of
 * earlier ones. A view that is not valid is reported as one error.
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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Position of the camera [m]; default 0 -100 20. In a parallel projection, any point of the plane from which the rays
   * start.
   */
  void SetViewPoint(double x, double y, double z);
  void SetViewPoint(const double point[3]) { this->SetViewPoint(point[0], point[1], point[2]); }
  vtkGetVector3Macro(ViewPoint, double);
  ///@}

  ///@{
  /**
   * Direction of projection, of any length but 0; default 0 1 0.
   */
  void SetViewDirection(double x, double y, double z);
  void SetViewDirection(const double d[3]) { this->SetViewDirection(d[0], d[1], d[2]); }
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * View-up vector, of any length but 0, not along ViewDirection; default 0 0 1.
   */
  void SetViewUp(double x, double y, double z);
  void SetViewUp(const double up[3]) { this->SetViewUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Vertical view angle of the camera [degrees], above 0 and below 180; default 30. In a parallel projection it affects
   * the levels of detail only, see ParallelScale.
   */
  void SetViewAngle(double angle);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * Parallel projection instead of perspective; default off.
   */
  void SetParallelProjection(bool parallel);
  vtkGetMacro(ParallelProjection, bool);
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  ///@{
  /**
   * Half the height of the viewport of a parallel projection [m], positive; default 100. The level of detail is then
   * the same everywhere: that of the distance at which a perspective of ViewAngle shows the same height, ParallelScale
   * / tan(ViewAngle / 2).
   */
  void SetParallelScale(double scale);
  vtkGetMacro(ParallelScale, double);
  ///@}

  ///@{
  /**
   * Width of the viewport relative to its height, positive; default 16 / 9.
   */
  void SetAspectRatio(double ratio);
  vtkGetMacro(AspectRatio, double);
  ///@}

  ///@{
  /**
   * Height of the viewport [pixels], positive; default 1080. Used where a screen-space error selects the level of
   * detail.
   */
  void SetViewHeight(double height);
  vtkGetMacro(ViewHeight, double);
  ///@}

  /// Copies ViewPoint, ViewDirection, ViewUp, ViewAngle, ParallelProjection and ParallelScale from a camera, for a
  /// viewport of AspectRatio. Off-axis projections, shears and window centers are not copied.
  void SetCamera(vtkCamera* camera);

  /// Copies camera, aspect ratio and height from a renderer before each rendering; null ends this.
  void Follow(vtkRenderer* renderer);

  ///@{
  /**
   * Distances from the camera up to which the first and the second level of detail are shown [m], not negative and not
   * decreasing; defaults 60 and 250 unless the subclass has its own. The third level is shown beyond. See ParallelScale
   * for the distance in a parallel projection.
   */
  vtkSetMacro(NearDistance, double);
  vtkGetMacro(NearDistance, double);
  vtkSetMacro(FarDistance, double);
  vtkGetMacro(FarDistance, double);
  ///@}

  ///@{
  /**
   * Factor of the level of detail, above 0 to 1; default 1, the full detail. The levels are those of NearDistance and
   * FarDistance times this factor, and of a screen-space error divided by it. ParaView lowers it while the camera
   * moves.
   */
  void SetDetailFactor(double factor);
  vtkGetMacro(DetailFactor, double);
  ///@}

  ///@{
  /**
   * Displacement of the camera that triggers a new execution [m], over DetailFactor, not negative; default 0, any
   * displacement.
   */
  vtkSetMacro(MoveTolerance, double);
  vtkGetMacro(MoveTolerance, double);
  ///@}

  ///@{
  /**
   * Rotation of the camera that triggers a new execution [degrees], 0 to 10; default 0, any rotation.
   */
  vtkSetMacro(TurnTolerance, double);
  vtkGetMacro(TurnTolerance, double);
  ///@}

protected:
  vtkViewDependentAlgorithm();
  ~vtkViewDependentAlgorithm() override;

  /// View of the request, rounded by the tolerances. Throws InvalidInput if a property of it is out of range.
  littoral::View GetView();

  /// Whether the output depends on where the view looks, beside from where; default true. Where it does not, a turn of
  /// the camera does not execute the filter.
  virtual bool DependsOnDirection() const { return true; }

  double ViewPoint[3];
  double ViewDirection[3];
  double ViewUp[3];
  double ViewAngle;
  bool ParallelProjection;
  double ParallelScale;
  double AspectRatio;
  double ViewHeight;
  double DetailFactor;
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
