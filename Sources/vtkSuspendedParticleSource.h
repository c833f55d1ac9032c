// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSuspendedParticleSource
 * @brief   generate particles suspended in water: plankton, marine snow, minerals
 *
 * Particles are distributed uniformly at random in boxes, one kind of particle per box. A Preset fills Bounds with
 * boxes of the kinds that live at each depth; with Custom the boxes are those of AddBox().
 *
 * Output 0: a vtkPolyData. Mode Points: one vertex per particle, with the point arrays `ParticleId`, `BoxId`,
 * `ParticleType` (0 diatom, 1 flake of marine snow, 2 grain, 3 copepod), `Radius` [m] and `RGB`. Mode Quads: one square
 * per particle with a random orientation and the texture coordinates of its kind. It has five points: the particle
 * itself, used by no cell, and four corners, which are its slaves by the point arrays `MasterId` and `Offset`[3] [m],
 * so that currents and waves move a square as a rigid body. Field data: `ParticleTypes`, the name of each value of
 * ParticleType, and `BoxNames`, one for each BoxId.
 *
 * Output 1: an RGBA vtkImageData with the textures of all kinds, one above the other. They are nearly white, to be
 * multiplied by `RGB`.
 *
 * A particle depends only on Seed, its box and its index in the box. Pieces are ranges of ParticleId. A parameter out
 * of range or Custom without a box is reported as one error.
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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

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

  enum AmountIsType
  {
    Concentration = 0,
    Count = 1,
  };

  ///@{
  /**
   * Composition of the particles, a PresetType; default CoastalSea. CoastalSea: algae in the upper part, animals in the
   * middle, marine snow everywhere, minerals near the bed. OpenOcean: clear water. PlanktonBloom: many algae near the
   * surface. StormyBed: resuspended sand and silt. Custom: the boxes of AddBox.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  void SetPresetToCustom() { this->SetPreset(Custom); }
  void SetPresetToCoastalSea() { this->SetPreset(CoastalSea); }
  void SetPresetToOpenOcean() { this->SetPreset(OpenOcean); }
  void SetPresetToPlanktonBloom() { this->SetPreset(PlanktonBloom); }
  void SetPresetToStormyBed() { this->SetPreset(StormyBed); }
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /**
   * Volume filled by a preset, as minimum and maximum x, minimum and maximum y, bed and surface [m], increasing;
   * default -10 10 -10 10 -10 0. Not used if Preset is Custom.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Factor of the amounts of all boxes, not negative; default 1.
   */
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}

  /// Adds a box, given by twelve numbers: minimum and maximum x, y and z [m], increasing; kind, 0 diatom, 1 flake, 2
  /// grain, 3 copepod; median diameter [m], positive, at most 10; amount, not negative, see AmountIs; red, green, blue,
  /// each 0 to 1. Used only if Preset is Custom. Boxes may overlap.
  void AddBox(const double box[12]);

  /// Names the box with the given index, whether already added or not; default: the kind and the index.
  void SetBoxName(int index, const char* name);

  /// Removes all boxes, but not their names.
  void RemoveAllBoxes();

  /// Removes the names of the boxes.
  void ClearBoxNames();

  /// Number of boxes added by AddBox.
  int GetNumberOfBoxes();

  ///@{
  /**
   * Meaning of the amount of a box, an AmountIsType; default Concentration. Concentration: particles per cubic meter.
   * Count: particles in the box. Presets have concentrations.
   */
  vtkSetMacro(AmountIs, int);
  vtkGetMacro(AmountIs, int);
  void SetAmountIsToConcentration() { this->SetAmountIs(Concentration); }
  void SetAmountIsToCount() { this->SetAmountIs(Count); }
  ///@}

  ///@{
  /**
   * Standard deviation of the natural logarithm of the diameters, 0 to 2; default 0.3.
   */
  vtkSetMacro(SizeSpread, double);
  vtkGetMacro(SizeSpread, double);
  ///@}

  ///@{
  /**
   * Representation of a particle, a ModeType; default Points. Points: a vertex, to be drawn as a sprite. Quads: a
   * textured square.
   */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  void SetModeToPoints() { this->SetMode(Points); }
  void SetModeToQuads() { this->SetMode(Quads); }
  ///@}

  ///@{
  /**
   * Precision of the points, vtkAlgorithm::SINGLE_PRECISION or DOUBLE_PRECISION; default SINGLE_PRECISION. Single
   * precision is faster in vtkParticleOrbitFilter; double precision is needed far from the origin.
   */
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same particles.
   */
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
  class vtkInternals;
  std::string WhyBadProperties() const;
  Recipe MakeRecipe() const;
  void NameBoxes(const Recipe& recipe, vtkPolyData* output) const;
  template <typename Array>
  bool Scatter(const Recipe& recipe, long long first, long long last, vtkPolyData* output);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
