// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The state of what casts shadows: another one for each change of a shape, the same for changes of colors.
#include "CasterState.h"
#include "CompositeMapper.h"
#include "LandscapePicture.h"
#include "vtkImpostorMapper.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSphereSource.h"

#include <functional>
#include <string>

namespace
{

/// Whether a change of what a prop is made of changes its state, and only if it should.
bool TestChange(vtkProp* prop, const std::function<void()>& change, bool isOther, const std::string& what)
{
  const std::uint64_t before = littoral::StateOf({ prop });
  change();
  return Check((littoral::StateOf({ prop }) != before) == isOther,
    "The state is " + std::string(isOther ? "the same" : "another one") + " with " + what);
}

vtkSmartPointer<vtkPolyData> Ball()
{
  vtkNew<vtkSphereSource> ball;
  ball->Update();
  return ball->GetOutput();
}

bool TestMesh()
{
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkLookupTable> table;
  mapper->SetLookupTable(table);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  bool good = TestChange(
    actor, [&] { table->SetRange(2.0, 3.0); }, false, "another range of colors");
  good &= TestChange(
    actor, [&] { ball->SetRadius(2.0); }, true, "a larger sphere upstream");
  good &= TestChange(
    actor, [&] { actor->SetPosition(1.0, 0.0, 0.0); }, true, "another place");
  return good & Check(littoral::StateOf({}) != littoral::StateOf({ actor }), "Nothing has the state of something.");
}

bool TestBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Ball());
  blocks->SetBlock(1, Ball());
  vtkNew<littoral::CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  bool good = TestChange(
    actor, [&] { attributes->Modified(); }, false, "attributes of blocks that were set anew");
  good &= TestChange(
    actor, [&] { attributes->SetBlockVisibility(blocks->GetBlock(1), false); }, true, "a block that is hidden");
  good &= TestChange(
    actor, [&] { attributes->SetBlockOpacity(blocks->GetBlock(0), 0.5); }, true, "a translucent block");
  return good &
    TestChange(
      actor, [&] { attributes->RemoveBlockVisibility(blocks->GetBlock(1)); }, true, "both blocks");
}

bool TestImpostors()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Ball());
  vtkNew<vtkActor> part;
  part->SetMapper(mapper);
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  vtkNew<vtkImpostorMapper> impostors;
  impostors->SetInputData(points);
  impostors->AddPart(part);
  vtkNew<vtkActor> actor;
  actor->SetMapper(impostors);
  bool good = TestChange(
    actor, [&] { mapper->GetLookupTable()->Modified(); }, false, "other colors of the plant");
  good &= TestChange(
    actor, [&] { part->SetScale(2.0); }, true, "a larger plant");
  return good &
    Check(impostors->GetPart(0) == part && !impostors->GetPart(1) && !impostors->GetPart(-1), "Other parts.");
}

}

int TestCasterState(int, char*[])
{
  bool good = TestMesh();
  good &= TestBlocks();
  good &= TestImpostors();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
