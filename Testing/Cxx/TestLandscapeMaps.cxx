// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Maps of shadows are drawn anew where something in them changed: coarse ones, whose texels do not tell leaves apart,
// by what props say that they cast in these.
#include "LandscapePicture.h"

#include "vtkInformation.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"

#include <cstdlib>
#include <string>

namespace
{

/// An actor that counts in how many maps it is drawn.
class Counted : public vtkOpenGLActor
{
public:
  static Counted* New();
  vtkTypeMacro(Counted, vtkOpenGLActor);

  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    vtkCamera* camera = static_cast<vtkRenderer*>(viewport)->GetActiveCamera();
    if (camera->GetParallelProjection()) // unlike that of the picture
    {
      ++(camera->GetInformation()->Has(vtkLandscapePass::COARSE_MAP()) ? this->Coarse : this->Fine);
    }
    return this->Superclass::RenderOpaqueGeometry(viewport);
  }

  int Coarse = 0;
  int Fine = 0;
};
vtkStandardNewMacro(Counted);

/// A box on a ground of 300 m, whose two smaller maps of the sun alone tell leaves apart.
struct Field : Picture
{
  vtkNew<Counted> Tree;

  explicit Field(int shape)
  {
    this->Pass->SetShadowDistance(60.0);
    this->Add(Level(150.0), 0.5);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(Box({ 0.0, 0.0, 3.0 }, { 3.0, 3.0, 6.0 }));
    this->Tree->SetMapper(mapper);
    this->SetShape(shape);
    this->Renderer->AddActor(this->Tree);
    this->Look({ 0.0, -30.0, 5.0 }, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 });
  }

  /// What the box casts in coarse maps; below 0: what it shows.
  void SetShape(int shape)
  {
    vtkNew<vtkInformation> keys;
    if (shape >= 0)
    {
      keys->Set(vtkLandscapePass::COARSE_SHAPE(), shape);
    }
    this->Tree->SetPropertyKeys(keys);
  }

  bool Drew(int fine, int coarse, const std::string& when)
  {
    this->Tree->Fine = this->Tree->Coarse = 0;
    this->Draw();
    return Check(this->Tree->Fine == fine && this->Tree->Coarse == coarse,
      when + " it is drawn in " + std::to_string(this->Tree->Fine) + " fine maps and " +
        std::to_string(this->Tree->Coarse) + " coarse ones.");
  }
};

bool TestRedrawn(int shape)
{
  const std::string what = "Shape " + std::to_string(shape) + ": ";
  Field field(shape);
  bool good = field.Drew(2, shape == 0 ? 0 : 2, what + "at first");
  field.Draw(); // VTK has made the actor's property
  good &= field.Drew(0, 0, what + "at rest");
  field.Tree->GetMapper()->Modified();
  good &= field.Drew(2, shape < 0 ? 2 : 0, what + "with another level");
  field.Tree->SetPosition(1.0, 0.0, 0.0);
  return good & field.Drew(2, shape == 0 ? 0 : 2, what + "moved");
}

bool TestOtherShape()
{
  Field field(7);
  field.Draw();
  field.Draw();
  field.Tree->GetPropertyKeys()->Set(vtkLandscapePass::COARSE_SHAPE(), 8);
  return field.Drew(0, 2, "With another shape");
}

/// With texels of half the length the map of all tells leaves apart; that of the zenith does not, for what hides the
/// sky within 5 m.
bool TestFinerMaps()
{
  Field field(0);
  field.Pass->SetMapSize(4096);
  return field.Drew(3, 0, "With fine maps");
}

}

int TestLandscapeMaps(int, char*[])
{
  bool good = TestOtherShape() & TestFinerMaps();
  for (const int shape : { -1, 0, 7 })
  {
    good &= TestRedrawn(shape);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
