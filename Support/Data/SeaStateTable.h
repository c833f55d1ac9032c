// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSeaStateTable_h
#define LittoralSupportSeaStateTable_h

// Sea states between the numerics and VTK: the one place that knows names and types of their columns. Private: never
// installed, never wrapped.

#include "Sea/SeaPeriods.h"
#include "Sea/SeaStatistics.h"
#include "Sea/WaveTrains.h"

#include <string>
#include <vector>

class vtkTable;

namespace littoral
{

/// Names of columns and arrays.
namespace sea
{
constexpr const char* Amplitude = "Amplitude";
constexpr const char* AngularFrequency = "AngularFrequency";
constexpr const char* WaveNumber = "WaveNumber";
constexpr const char* Direction = "Direction";
constexpr const char* Phase = "Phase";
constexpr const char* WaterDepth = "WaterDepth";
constexpr const char* SeaLevel = "SeaLevel";
constexpr const char* SignificantWaveHeight = "SignificantWaveHeight";
constexpr const char* PeakPeriod = "PeakPeriod";
constexpr const char* Period = "Period";                         ///< after which the sea returns [s]
constexpr const char* Order = "Order";                           ///< SeaOrder; absent: First
constexpr const char* EnergyPeriod = "EnergyPeriod";             ///< Tm-1,0 [s]
constexpr const char* MeanPeriod = "MeanPeriod";                 ///< Tm01 [s]
constexpr const char* ZeroCrossingPeriod = "ZeroCrossingPeriod"; ///< Tm02 [s]
constexpr const char* MeanDirection = "MeanDirection";           ///< towards, from x towards y, by energy [degrees]
constexpr const char* DirectionalSpread = "DirectionalSpread";   ///< circular, (2 (1 - r))^0.5 [degrees]
constexpr const char* DirectionTowards = "DirectionTowards";     ///< at a frequency, from x towards y [degrees]
constexpr const char* Skewness = "Skewness";                     ///< of the elevation, by trains of second order
constexpr const char* EnergyLeftOut = "EnergyLeftOut";           ///< part of the spectrum's
constexpr const char* BinEdges = "BinEdges";               ///< frequencies between which the bins of trains lie [Hz]
constexpr const char* SpectralDensity = "SpectralDensity"; ///< at the edges and at equal steps within each bin [m2/Hz]
// Particles.
constexpr const char* ParticleId = "ParticleId";
constexpr const char* ParticleType = "ParticleType";
constexpr const char* BoxId = "BoxId";
constexpr const char* Radius = "Radius"; ///< [m]
constexpr const char* RGB = "RGB";
constexpr const char* MasterId = "MasterId";
constexpr const char* Offset = "Offset"; ///< of a slave from its master [m]
constexpr const char* Captured = "Captured";
constexpr const char* Start = "Start";     ///< where a particle that drifts began [m]
constexpr const char* Way = "DriftWay";    ///< that all particles have gone from there, as field data [m]
constexpr const char* Current = "Current"; ///< [m/s]
// Field data of particles: a word for each value of ParticleType and BoxId.
constexpr const char* ParticleTypes = "ParticleTypes";
constexpr const char* BoxNames = "BoxNames";
// Flow primitives.
constexpr const char* FlowType = "FlowType";
constexpr const char* Strength = "Strength";
constexpr const char* Axis = "Axis";
constexpr const char* CoreRadius = "CoreRadius";
constexpr const char* InfluenceRadius = "InfluenceRadius";
constexpr const char* InfluenceBox = "InfluenceBox"; ///< smallest and largest x, y, z [m]
constexpr const char* InfluenceMargin = "InfluenceMargin";

// Levels of detail of particles: blocks, their point arrays, and a field array.
constexpr const char* Near = "Near";
constexpr const char* MasterSlave = "MasterSlave";
constexpr const char* Far = "Far";
constexpr const char* Alpha = "Alpha";
constexpr const char* TrainCount = "TrainCount";
constexpr const char* ErrorBound = "ErrorBound";
constexpr const char* TrainOrder = "TrainOrder";

// Fog.
constexpr const char* Extinction = "Extinction";
}

/// Writes the trains as rows; depth, level and period as field data.
void WriteSeaState(const SeaState& state, vtkTable* table);

/// Writes the spectrum of a sea as field data: edges of bins, and densities at them and within the bins.
void WriteSpectrum(const SeaSpectrum& spectrum, const TrainParameters& parameters, vtkTable* table);

/// Writes the periods by moments as field data.
void WritePeriods(const SeaPeriods& periods, vtkTable* table);

/// Writes mean direction and spread as field data.
void WriteDirection(const MeanVector& mean, vtkTable* table);

/// A spectrum as WriteSpectrum wrote it.
struct SampledSpectrum
{
  std::vector<double> Edges;     ///< [Hz]
  std::vector<double> Densities; ///< [m2/Hz]
};

/// Reads what WriteSpectrum wrote. Throws InvalidInput.
SampledSpectrum ReadSpectrum(vtkTable* table);

/// Reads what WriteSeaState wrote. Throws InvalidInput.
SeaState ReadSeaState(vtkTable* table);

}

#endif
