// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A landscape by vtkLandscapePass is the same picture in whatever order its parts are added.
#include "LandscapePicture.h"

#include "vtkPropCollection.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <string>
#include <vector>

namespace
{

/// A shore with a river, a sea, boxes and the crown of a plant.
struct Shore : Picture
{
  Shore()
  {
    using Kind = vtkLandscapePass;
    Kind::SetMaterial(this->Add(Plane({ -30, -30, -4 }, { 30, -30, -4 }, { -30, 30, 4 }), 0.3), Kind::Ground);
    Kind::SetMaterial(this->Add(Plane({ -30, -30, 0 }, { 30, -30, 0 }, { -30, 20, 0 }), 0.2), Kind::Water);
    Kind::SetMaterial(this->Add(Plane({ 6, -1, 0.1 }, { 10, -1, 0.1 }, { 6, 30, 4.2 }), 0.2), Kind::River);
    this->Add(Box({ -5.0, 0.0, 1.0 }, { 2.0, 2.0, 3.0 }), 0.6);
    this->Add(Box({ 1.0, -4.0, 0.0 }, { 2.0, 2.0, 2.0 }), 0.4); // partly in the sea
    vtkNew<vtkSphereSource> crown;
    crown->SetCenter(-1.0, 5.0, 3.0);
    crown->SetRadius(1.5);
    crown->Update();
    Kind::SetTransmittance(this->Add(crown->GetOutput(), 0.3), 0.3);
    this->Pass->SetCoverHeight(0.4);
    this->Pass->SetShoreRunUp(0.3);
  }

  /// Adds all anew, beginning with another one, or backward.
  void Reorder(int first, bool isBackward)
  {
    std::vector<vtkProp*> props;
    vtkPropCollection* all = this->Renderer->GetViewProps();
    for (int k = 0; k < all->GetNumberOfItems(); ++k)
    {
      props.push_back(vtkProp::SafeDownCast(all->GetItemAsObject(k)));
    }
    const std::vector<vtkSmartPointer<vtkProp>> kept(props.begin(), props.end());
    this->Renderer->RemoveAllViewProps();
    std::rotate(props.begin(), props.begin() + first, props.end());
    if (isBackward)
    {
      std::reverse(props.begin(), props.end());
    }
    for (vtkProp* prop : props)
    {
      this->Renderer->AddViewProp(prop);
    }
  }
};

}

int TestLandscapeOrder(int, char*[])
{
  bool good = true;
  for (const double height : { 5.0, -1.5 })
  {
    Shore picture;
    picture.Look({ 2.0, -14.0, height }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Draw();
    vtkNew<vtkUnsignedCharArray> first;
    first->DeepCopy(picture.Pixels);
    for (const int turn : { 0, 2 })
    {
      picture.Reorder(turn, turn == 0);
      picture.Draw();
      int most = 0;
      for (vtkIdType k = 0; k < first->GetNumberOfValues(); ++k)
      {
        most = std::max(most, std::abs(first->GetValue(k) - picture.Pixels->GetValue(k)));
      }
      good &= Check(most <= 1, "Another order of what is shown changes a picture by " + std::to_string(most));
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
