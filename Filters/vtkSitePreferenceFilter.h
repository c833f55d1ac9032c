// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSitePreferenceFilter
 * @brief   let the terrain decide which species grow on which sites
 *
 * Inputs: port 0, the sites (vtkPointSet, such as points of a pattern); port 1, the terrain (vtkImageData of one layer,
 * point array `Elevation` [m] or else the active scalars; optional point array `DrainageArea` [m2], positive); port 2,
 * optional, the preferences (vtkTable with a row a species).
 *
 * Columns of the preferences: `species` (name), `abundance` (not negative, default 1), and for each factor an optimum
 * and a tolerance: `elevation` and `elevation_tolerance` [m]; `relative_elevation` (0 at the lowest point of the
 * terrain, 1 at the highest); `slope` [degrees]; `aspect` (direction that the slope faces, clockwise from north
 * [degrees]); `wetness` (topographic wetness index ln(a / tan(slope)), a being DrainageArea over the width of a cell
 * [m]; Beven and Kirkby 1979). An empty optimum: no response. The preference of a species for a site is
 * the product over its factors of exp(-(v - optimum)^2 / (2 tolerance^2)) (ter Braak and Looman 1986); aspect counts in
 * proportion to the slope below 5 degrees. Without a table there are four species: Pine prefers high ground, Oak low
 * ground, Birch level ground between, or moist ground where the terrain has a DrainageArea, and Shrub slopes.
 *
 * A site gets species s with probability a(s) p(s) / sum of a p, where a is the abundance and p the preference. With
 * Thinning it gets s with probability a(s) p(s) / sum of a, or none and is left out. A site with the point array
 * `Species` (index of a row) keeps its species; with Thinning it is kept itself with the probability of its preference.
 *
 * Output: vtkPolyData, a vertex for each site that is kept, at the height of the terrain, with the point arrays of the
 * sites and `Species`, `SiteId` (index of the site, unless the sites have one), `Elevation` [m], `Slope` and `Aspect`
 * [degrees], `RGB` (a color a species), and `Wetness` if the terrain has a DrainageArea. Field data: `SpeciesNames`. A
 * site's fate depends on Seed and its SiteId alone.
 *
 * A table that holds no preferences, no terrain, a preference for wetness on a terrain without DrainageArea, a Species
 * that has no row, and a site beyond the terrain are reported as one error.
 *
 * @sa vtkPlantScatterFilter
 */
#ifndef vtkSitePreferenceFilter_h
#define vtkSitePreferenceFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkSitePreferenceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSitePreferenceFilter* New();
  vtkTypeMacro(vtkSitePreferenceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Thinning of the sites by the preferences of their species; default off: all sites are kept, and those without a
   * species get s with probability a(s) p(s) / sum of a p; only where all preferences are 0 a site is left out.
   */
  vtkSetMacro(Thinning, bool);
  vtkGetMacro(Thinning, bool);
  vtkBooleanMacro(Thinning, bool);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /// Connects the terrain, port 1.
  void SetTerrainConnection(vtkAlgorithmOutput* terrain) { this->SetInputConnection(1, terrain); }

  /// Connects a table of preferences, port 2.
  void SetPreferencesConnection(vtkAlgorithmOutput* preferences) { this->SetInputConnection(2, preferences); }

  /// Removes the connection of port 2.
  void RemovePreferences() { this->RemoveAllInputConnections(2); }

protected:
  vtkSitePreferenceFilter();
  ~vtkSitePreferenceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool Thinning;
  int Seed;

private:
  vtkSitePreferenceFilter(const vtkSitePreferenceFilter&) = delete;
  void operator=(const vtkSitePreferenceFilter&) = delete;
};

#endif
