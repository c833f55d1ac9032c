// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The mapper of a block draws what VTK's draws, also after a move, with other colors and when the graphics are taken
// from it and given back, and keeps none of the vertices that it has sent. Many triangles, which are drawn by parts,
// give the same picture and leave less memory taken than VTK's. Arrays that are read where they are do so too, also
// when they have changed, have got other memory, or are drawn by a mapper of VTK in the same window; of points that are
// not shifted and of triangles the picture has the same bytes, and the same cells are picked.
#include "BlockMapper.h"
#include "Check.h"
#include "PinnedArray.h"
#include "vtkLandscapePass.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

/// Where the ball is [m], so far from the origin that VTK shifts its points before it sends them.
constexpr double East = 500000.0;
constexpr double North = 4000000.0;

/// Where a sheet is, to the north and to the east [m].
constexpr double Near = 300.0;

constexpr int Side = 60; // pixels of a picture

/// A triangle [m].
constexpr double Corners[3][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { -1.0, 1.0 } };

/// A sphere with normals and colors of its points.
void FillBall(vtkPolyData* ball)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(East, North, 0.0);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  ball->ShallowCopy(source->GetOutput());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const int points = static_cast<int>(ball->GetNumberOfPoints());
  for (int n = 0; n < points; ++n)
  {
    colors->InsertNextTuple3(n % 256, 5 * n % 256, 200);
  }
  ball->GetPointData()->SetScalars(colors);
}

/// Tells of the colors that it keeps, and whether the graphics have the corners of all triangles.
class MapperOfColors : public littoral::BlockMapper
{
public:
  static MapperOfColors* New();
  vtkTypeMacro(MapperOfColors, littoral::BlockMapper);

  vtkIdType KeptColors() const { return this->Colors->GetNumberOfTuples(); }
  bool HasCorners() const { return this->Primitives[PrimitiveTris].IBO->GetHandle() != 0; }
};
vtkStandardNewMacro(MapperOfColors);

/// A mapper of a ball in a window of its own.
struct Shown
{
  Shown(vtkOpenGLPolyDataMapper* mapper, vtkPolyData* ball, double east = East, double north = North)
    : Mapper(mapper)
  {
    mapper->SetInputData(ball);
    mapper->SetColorModeToDirectScalars();
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->GetActiveCamera()->SetFocalPoint(east, north, 0.0);
    this->Renderer->GetActiveCamera()->SetPosition(east, north, 4.0);
    this->Window->OffScreenRenderingOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
  }

  std::vector<unsigned char> Picture()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, Side - 1, Side - 1, /*front=*/0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }

  /// For how many numbers of vertices that the graphics have there is memory.
  std::size_t KeptNumbers(const char* attribute)
  {
    vtkOpenGLVertexBufferObject* sent = this->Mapper->GetVBOs()->GetVBO(attribute);
    return sent ? sent->GetPackedVBO().capacity() : 1;
  }

  vtkOpenGLPolyDataMapper* Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

bool CheckKeptNumbers(Shown& blocks, Shown& plain, const std::string& when)
{
  const bool good = Check(plain.KeptNumbers("vertexMC") > 1, when + ": VTK keeps no vertices");
  const auto* mapper = static_cast<MapperOfColors*>(blocks.Mapper);
  return Check(blocks.KeptNumbers("vertexMC") == 0, when + ": vertices are sent and kept") &&
    Check(mapper->KeptColors() == 1, when + ": colors are sent and kept") && good;
}

/// Triangles of a square of two metres, one behind the other, of colors that go from black to white.
void FillStack(vtkPolyData* stack, int triangles)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  stack->SetPoints(vtkNew<vtkPoints>());
  stack->SetPolys(vtkNew<vtkCellArray>());
  for (int n = 0; n < triangles; ++n)
  {
    const double turn = n % 4 < 2 ? 1.0 : -1.0;
    const double depth = static_cast<double>(n % 1000) / 1000.0;
    stack->GetPolys()->InsertNextCell(3);
    for (const double* corner : { Corners[0], Corners[1], Corners[2] })
    {
      const vtkIdType point =
        stack->GetPoints()->InsertNextPoint(East + turn * corner[0], North + turn * corner[1], -depth);
      stack->GetPolys()->InsertCellPoint(point);
      colors->InsertNextTuple3(255.0 * n / triangles, n % 256, n / 256 % 256);
    }
  }
  stack->GetPointData()->SetScalars(colors);
}

/// Memory that is taken [MB].
double TakenMemory()
{
  const struct mallinfo2 memory = mallinfo2();
  return static_cast<double>(memory.uordblks + memory.hblkhd) / 1e6;
}

/// Memory that a picture leaves taken [MB].
double MemoryOf(Shown& shown, std::vector<unsigned char>& picture)
{
  const double before = TakenMemory();
  picture = shown.Picture();
  return TakenMemory() - before;
}

bool CheckParts()
{
  vtkNew<vtkPolyData> stack;
  FillStack(stack, 300000);
  vtkNew<littoral::BlockMapper> byParts;
  vtkNew<vtkOpenGLPolyDataMapper> atOnce;
  Shown blocks(byParts, stack);
  Shown plain(atOnce, stack);
  std::vector<unsigned char> picture;
  std::vector<unsigned char> expected;
  const double ofParts = MemoryOf(blocks, picture);
  const double ofVtk = MemoryOf(plain, expected);
  std::cout << ofParts << " MB by parts, " << ofVtk << " MB at once\n";
  // A sanitizer's heap tells of nothing, and a graphics card has its own memory.
  const bool isTold = ofVtk > 0.0 && vtkLandscapePass::IsDrawnBySoftware(blocks.Window);
  const bool isSame = Check(picture == expected, "by parts: another picture than VTK's");
  return Check(!isTold || ofParts < 0.7 * ofVtk, "what is drawn by parts is kept") && isSame;
}

/// A sheet, seen from above, with normals that lean to and fro.
void FillSheet(vtkPolyData* sheet, int side)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(side, side);
  source->SetOrigin(Near - 1.0, Near - 1.0, 0.0);
  source->SetPoint1(Near + 1.0, Near - 1.0, 0.0);
  source->SetPoint2(Near - 1.0, Near + 1.0, 0.0);
  source->Update();
  sheet->ShallowCopy(source->GetOutput());
  vtkDataArray* normals = sheet->GetPointData()->GetNormals();
  for (vtkIdType n = 0; n < normals->GetNumberOfTuples(); ++n)
  {
    normals->SetTuple3(n, 0.6 * std::sin(0.001 * static_cast<double>(n)), 0.0, 0.8);
  }
}

/// The same of double precision, which is not read where it is.
void FillCopy(vtkPolyData* sheet, vtkPolyData* copy)
{
  copy->ShallowCopy(sheet);
  vtkNew<vtkDoubleArray> places;
  places->DeepCopy(sheet->GetPoints()->GetData());
  vtkNew<vtkPoints> points;
  points->SetData(places);
  copy->SetPoints(points);
  vtkNew<vtkDoubleArray> normals;
  normals->DeepCopy(sheet->GetPointData()->GetNormals());
  copy->GetPointData()->SetNormals(normals);
}

/// How far a picture is from another one, as a mean of the channels; pixels at edges may be others.
double Difference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size() && a.size() == b.size(); ++n)
  {
    sum += std::abs(static_cast<double>(a[n]) - b[n]);
  }
  return a.empty() || a.size() != b.size() ? 255.0 : sum / static_cast<double>(a.size());
}

/// Whether a mapper reads arrays where they are.
bool IsInPlace(Shown& shown)
{
  return littoral::PinnedArray::IsPossible(vtkOpenGLRenderWindow::SafeDownCast(shown.Window));
}

bool CheckReadInPlace()
{
  constexpr double least = 0.1;
  vtkNew<vtkPolyData> sheet;
  FillSheet(sheet, 500);
  vtkNew<littoral::BlockMapper> inPlace;
  vtkNew<vtkOpenGLPolyDataMapper> sent;
  inPlace->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE); // as ParaView does
  sent->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
  Shown blocks(inPlace, sheet, Near, Near);
  Shown plain(sent, sheet, Near, Near);
  vtkNew<vtkPolyData> copy;
  FillCopy(sheet, copy);
  vtkNew<littoral::BlockMapper> ofCopy;
  Shown copied(ofCopy, copy, Near, Near);
  const std::vector<unsigned char> picture = blocks.Picture();
  bool good = Check(Difference(picture, copied.Picture()) < least, "in place: another picture than of a copy");
  std::vector<unsigned char> expected = plain.Picture();
  good &= Check(Difference(picture, expected) < least, "in place: another picture than VTK's");
  const bool isInPlace = IsInPlace(blocks);

  auto* points = vtkFloatArray::SafeDownCast(sheet->GetPoints()->GetData());
  auto* normals = vtkFloatArray::SafeDownCast(sheet->GetPointData()->GetNormals());
  const std::vector<unsigned char> first = expected;
  for (vtkIdType n = 0; n < points->GetNumberOfTuples(); ++n)
  {
    normals->SetTypedComponent(n, 2, 0.4f);
  }
  good &= Check(!isInPlace || blocks.Picture() != first, "normals in place have a copy");
  for (vtkIdType n = 0; n < points->GetNumberOfTuples(); ++n)
  {
    points->SetTypedComponent(n, 0, points->GetTypedComponent(n, 0) + 0.7f);
  }
  points->Modified();
  normals->Modified();
  sheet->Modified();
  expected = plain.Picture();
  good &= Check(Difference(expected, first) > 10.0 * least, "the sheet is as it was");
  good &= Check(Difference(blocks.Picture(), expected) < least, "moved in place: another picture than VTK's");

  normals->Resize(2 * normals->GetNumberOfTuples());
  points->Resize(2 * points->GetNumberOfTuples());
  std::vector<float> over(12 * normals->GetNumberOfTuples(), 0.0f); // where they were, likely
  good &= Check(over.back() == 0.0f && Difference(blocks.Picture(), expected) < least, "memory that was left is read");

  vtkNew<vtkOpenGLPolyDataMapper> other;
  other->SetInputData(sheet);
  other->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
  vtkNew<vtkActor> actor;
  actor->SetMapper(other);
  blocks.Renderer->AddActor(actor);
  blocks.Picture();
  blocks.Actor->VisibilityOff();
  return Check(Difference(blocks.Picture(), expected) < least, "another mapper of the points draws them elsewhere") &&
    good;
}

/// A sheet of triangles, whose cells have numbers of 32 bits.
void FillTriangles(vtkPolyData* triangles, int side)
{
  vtkNew<vtkPolyData> sheet;
  FillSheet(sheet, side);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(sheet);
  filter->Update();
  triangles->ShallowCopy(filter->GetOutput());
  triangles->GetPolys()->ConvertTo32BitStorage();
}

/// Cells that VTK's selector finds in all of a picture.
std::vector<vtkIdType> PickedCells(Shown& shown)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(shown.Renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto picked = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  auto* cells = picked && picked->GetNumberOfNodes() == 1
    ? vtkIdTypeArray::SafeDownCast(picked->GetNode(0)->GetSelectionList())
    : nullptr;
  return cells ? std::vector<vtkIdType>(cells->GetPointer(0), cells->GetPointer(0) + cells->GetNumberOfValues())
               : std::vector<vtkIdType>();
}

/// Whether a block shows and picks what VTK's mapper does.
bool CheckSame(Shown& blocks, Shown& plain, const std::string& when)
{
  const bool isSame = Check(blocks.Picture() == plain.Picture(), when + ": another picture than VTK's");
  const std::vector<vtkIdType> expected = PickedCells(plain);
  return Check(expected.size() > Side, when + ": VTK picks no cells") &&
    Check(PickedCells(blocks) == expected, when + ": other cells are picked than by VTK") && isSame;
}

bool CheckTrianglesInPlace()
{
  vtkNew<vtkPolyData> triangles;
  FillTriangles(triangles, 150);
  vtkNew<littoral::BlockMapper> inPlace;
  vtkNew<vtkOpenGLPolyDataMapper> sent;
  inPlace->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  sent->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  Shown blocks(inPlace, triangles, Near, Near);
  Shown plain(sent, triangles, Near, Near);
  bool good = CheckSame(blocks, plain, "triangles in place");
  const bool isInPlace = IsInPlace(blocks);
  const std::vector<unsigned char> first = blocks.Picture();

  vtkPoints* points = triangles->GetPoints();
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    const double* point = points->GetPoint(n);
    points->SetPoint(n, point[0] + 0.7, point[1], point[2]);
  }
  good &= Check(!isInPlace || blocks.Picture() != first, "points in place have a copy");
  points->Modified();
  triangles->Modified();
  good &= CheckSame(blocks, plain, "moved triangles in place");

  points->Modified();
  triangles->Modified();
  const std::vector<unsigned char> second = blocks.Picture();
  auto* corners =
    vtkArrayDownCast<vtkAOSDataArrayTemplate<vtkTypeInt32>>(triangles->GetPolys()->GetConnectivityArray());
  const vtkIdType numbers = corners->GetNumberOfValues();
  auto* moved = new vtkTypeInt32[numbers]; // becomes the array's
  std::copy_n(corners->GetPointer(0), numbers, moved);
  std::fill_n(corners->GetPointer(0), numbers, 0);
  good &= Check(!isInPlace || blocks.Picture() != second, "triangles in place have a copy");
  corners->SetArray(moved, numbers, /*save=*/0, vtkAbstractArray::VTK_DATA_ARRAY_DELETE);
  good &= CheckSame(blocks, plain, "triangles that have got other memory");

  // A triangle without an area, of whose corners VTK may send none.
  corners->SetValue(1, corners->GetValue(0));
  triangles->GetPolys()->Modified();
  triangles->Modified();
  good &= CheckSame(blocks, plain, "with a triangle of no area");
  inPlace->ReleaseGraphicsResources(blocks.Window);
  return CheckSame(blocks, plain, "triangles after a release") && good;
}

/// A sheet of quadrangles, each of which has its own points, the next ones; or the first and the last one changed.
void FillQuadrangles(vtkPolyData* quadrangles, int side, bool areInOrder)
{
  vtkNew<vtkPolyData> sheet;
  FillSheet(sheet, side);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  const vtkIdType count = sheet->GetNumberOfPolys();
  vtkNew<vtkIdList> corners;
  for (vtkIdType n = 0; n < count; ++n)
  {
    sheet->GetPolys()->GetCellAtId(n, corners);
    cells->InsertNextCell(4);
    const vtkIdType own = n == 0 ? count - 1 : n == count - 1 ? 0 : n;
    for (int corner = 0; corner < 4; ++corner)
    {
      points->InsertNextPoint(sheet->GetPoint(corners->GetId(corner)));
      normals->InsertNextTuple(sheet->GetPointData()->GetNormals()->GetTuple(corners->GetId(corner)));
      cells->InsertCellPoint(4 * (areInOrder ? n : own) + corner);
    }
  }
  quadrangles->SetPoints(points);
  quadrangles->GetPointData()->SetNormals(normals);
  quadrangles->SetPolys(cells);
}

/// Quadrangles in order are drawn by the numbers of some corners, others by those of all.
bool CheckQuadrangles()
{
  constexpr int side = 150;
  bool good = true;
  for (const bool areInOrder : { true, false })
  {
    vtkNew<vtkPolyData> quadrangles;
    FillQuadrangles(quadrangles, side, areInOrder);
    vtkNew<MapperOfColors> mapper;
    vtkNew<vtkOpenGLPolyDataMapper> ofVtk;
    Shown blocks(mapper, quadrangles, Near, Near);
    Shown plain(ofVtk, quadrangles, Near, Near);
    const std::string kind = areInOrder ? "quadrangles in order" : "other quadrangles";
    good &= CheckSame(blocks, plain, kind);
    quadrangles->GetPoints()->Modified();
    good &= Check(blocks.Picture() == plain.Picture(), kind + ", sent again: another picture than VTK's");
    good &=
      Check(mapper->HasCorners() != (areInOrder && IsInPlace(blocks)), kind + ": corners of all are sent, or none");
  }
  return good;
}

/// A point that no cell uses, 20 m east of the ball, is within the bounds of the mapper, which are those of the points.
bool CheckBounds()
{
  vtkNew<vtkPolyData> ball;
  FillBall(ball);
  ball->GetPoints()->InsertNextPoint(East + 20.0, North, 0.0);
  vtkNew<littoral::BlockMapper> mapper;
  mapper->SetInputData(ball);
  const double* bounds = mapper->GetBounds();
  const double* expected = ball->GetPoints()->GetBounds();
  return Check(
    std::equal(bounds, bounds + 6, expected) && bounds[1] == East + 20.0, "other bounds than those of the points");
}

}

int TestBlockMapper(int, char*[])
{
  vtkNew<vtkPolyData> ball;
  FillBall(ball);
  vtkNew<MapperOfColors> ofBlocks;
  vtkNew<vtkOpenGLPolyDataMapper> ofVtk;
  Shown blocks(ofBlocks, ball);
  Shown plain(ofVtk, ball);
  const std::vector<unsigned char> first = plain.Picture();
  bool good = Check(blocks.Picture() == first, "first: another picture than VTK's");
  good &= CheckKeptNumbers(blocks, plain, "first");

  vtkPoints* points = ball->GetPoints();
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    const double* point = points->GetPoint(n);
    points->SetPoint(n, 0.5 * (point[0] + East) + 0.4, point[1], point[2]);
  }
  points->Modified();
  ball->Modified();
  const std::vector<unsigned char> moved = plain.Picture();
  good &= Check(moved != first, "the ball has not moved");
  good &= Check(blocks.Picture() == moved, "moved: another picture than VTK's");
  good &= CheckKeptNumbers(blocks, plain, "moved");

  auto* colors = vtkUnsignedCharArray::SafeDownCast(ball->GetPointData()->GetScalars());
  colors->FillComponent(0, 255.0);
  colors->Modified();
  const std::vector<unsigned char> colored = plain.Picture();
  good &= Check(colored != moved, "the ball has its former colors");
  good &= Check(blocks.Picture() == colored, "colored: another picture than VTK's");
  good &= CheckKeptNumbers(blocks, plain, "colored");

  const vtkUnsignedCharArray* all = ofBlocks->MapScalars(1.0);
  good &= Check(all->GetNumberOfTuples() == ball->GetNumberOfPoints(), "exporters get colors that were dropped");
  good &= Check(blocks.Picture() == colored, "after an export: another picture than VTK's");
  points->Modified();
  good &= Check(blocks.Picture() == colored, "sent after an export: another picture than VTK's");
  good &= CheckKeptNumbers(blocks, plain, "sent after an export");

  ofBlocks->ReleaseGraphicsResources(blocks.Window);
  good &= Check(blocks.Picture() == colored, "after a release: another picture than VTK's");
  good &= CheckKeptNumbers(blocks, plain, "after a release");
  good &= CheckBounds();
  good &= CheckParts();
  good &= CheckReadInPlace();
  good &= CheckTrianglesInPlace();
  good &= CheckQuadrangles();
  return good ? 0 : 1;
}
