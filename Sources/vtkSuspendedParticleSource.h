// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSuspendedParticleSource
 * @brief   particles that hang in the water: plankton, marine snow, minerals
 *
 * Particles lie at random places in boxes, of one kind a box. Boxes come from a Preset, which fills Bounds with kinds
 * where they live, or are given one by one.
 *
 * Output 0: a vtkPolyData. As Points, a vertex a particle, with the point arrays `ParticleId`, `BoxId`, `ParticleType`
 * (0 diatom, 1 flake of marine snow, 2 grain, 3 copepod), `Radius` [m] and `RGB`. As Quads, a square a particle with a
 * random orientation and texture coordinates of its picture: five points each, the particle itself, which no cell uses,
 * and the corners, which are its slaves by `MasterId` and `Offset`, so that currents and waves move squares as a whole.
 * Field data: `ParticleTypes`, a word for each value of ParticleType, and `BoxNames`, one for each BoxId.
 *
 * Output 1: an image with the pictures of all kinds, one above the other, as bytes RGBA. They are nearly white, to be
 * multiplied by RGB.
 *
 * A particle depends on Seed, its box and its number in the box alone. Pieces are ranges of ParticleId.
 *
 * Coulais et al., section 3.1.
 *
 * @sa vtkCurrentDriftFilter vtkParticleOrbitFilter
 */
#ifndef vtkSuspendedParticleSource_h
#define vtkSuspendedParticleSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class LITTORALSOURCES_EXPORT vtkSuspendedParticleSource : public vtkPolyDataAlgorithm
{
public:
  static vtkSuspendedParticleSource* New();
  vtkTypeMacro(vtkSuspendedParticleSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PresetType
  {
    Custom = 0,
    CoastalSea = 1,
    OpenOcean = 2,
    PlanktonBloom = 3,
    StormyBed = 4,
  };

  enum ModeType
  {
    Points = 0,
    Quads = 1,
  };

  enum AmountType
  {
    Concentration = 0,
    Count = 1,
  };

  ///@{
  /**
   * A PresetType. Custom: the boxes that AddBox makes. CoastalSea: algae in the upper part, animals in the middle,
   * marine snow everywhere, minerals near the bed. OpenOcean: clear water. PlanktonBloom: many algae near the surface.
   * StormyBed: sand and silt whirled up. Default CoastalSea.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /// What a preset fills [m]: smallest and largest x, y, and the bed and the surface. Of no effect in Custom. Default
  /// -10 10 -10 10 -10 0.
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Factor of the amounts of all boxes, not negative. Default 1.
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}

  /**
   * Adds a box, twelve numbers: smallest and largest x, y, z [m]; kind, 0 diatom, 1 flake, 2 grain, 3 copepod; median
   * diameter [m]; amount, see AmountIs; red, green, blue (0 to 1). Of no effect unless Preset is Custom. Boxes may
   * meet.
   */
  void AddBox(const double box[12]);

  /// Names the box that was, or will be, added as number `index`. Default: the kind and the number.
  void SetBoxName(int index, const char* name);

  /// Forgets all boxes, but not their names.
  void RemoveAllBoxes();

  /// Forgets the names of boxes.
  void ClearBoxNames();

  /// How many boxes AddBox made.
  int GetNumberOfBoxes();

  ///@{
  /// An AmountType: what the amount of a box counts, particles in a cubic metre or in the box. Presets have
  /// concentrations. Default Concentration.
  vtkSetMacro(AmountIs, int);
  vtkGetMacro(AmountIs, int);
  ///@}

  ///@{
  /// Standard deviation of the logarithm of diameters, 0 to 2. Default 0.3.
  vtkSetMacro(SizeSpread, double);
  vtkGetMacro(SizeSpread, double);
  ///@}

  ///@{
  /// A ModeType: points, to be drawn as sprites, or squares with a picture. Default Points.
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /// vtkAlgorithm::SINGLE_PRECISION or DOUBLE_PRECISION of points. Single goes the fast way through waves; take double
  /// far from the origin. Default SINGLE_PRECISION.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// Any whole number; the same seed gives the same particles. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkSuspendedParticleSource();
  ~vtkSuspendedParticleSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Preset;
  double Bounds[6];
  double Density;
  int AmountIs;
  double SizeSpread;
  int Mode;
  int OutputPointsPrecision;
  int Seed;

private:
  vtkSuspendedParticleSource(const vtkSuspendedParticleSource&) = delete;
  void operator=(const vtkSuspendedParticleSource&) = delete;

  class Recipe;
  class BoxList;
  std::string MakeRecipe(Recipe& recipe) const;
  void NameBoxes(const Recipe& recipe, vtkPolyData* output) const;
  template <typename Array>
  bool Scatter(const Recipe& recipe, long long first, long long last, vtkPolyData* output);

  std::unique_ptr<BoxList> Boxes;
};

#endif
