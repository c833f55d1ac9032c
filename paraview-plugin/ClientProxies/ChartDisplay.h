// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralChartDisplay_h
#define LittoralChartDisplay_h

#include "Observation.h"

#include "vtkWeakPointer.h" // for observed proxies

#include <string>
#include <vector>

class vtkObject;
class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMSessionProxyManager;
class vtkSMSourceProxy;
class vtkSMViewProxy;

namespace littoral
{

/**
 * Initial display of tables in ParaView, ready to print.
 *
 * ParaView draws all columns of a table over the row number and lists columns by the alphabet. The hint
 *
 *     <ChartDisplay port="1" x="Lag" x-title="Lag [m]" y-title="Semivariance [m²]" log="xy" legend="BottomRight">
 *       <Points name="Semivariance" label="Measured" />
 *       <Lines names="Model" of-port="0" count="3" />
 *     </ChartDisplay>
 *
 * of the owner describes the chart of an output: the column of the x axis, titles of the axes, logarithmic axes, corner
 * of the legend, and the visible series in the order of their colors. A series is drawn as Points, Lines or Bars; its
 * label is its name in words unless given, its color the next one unless color="..." numbers it. The names of several
 * series can be the first values of a column of text (here the best models), which change with the data. The hint
 *
 *     <TableDisplay port="0" columns="Model Variance AICc" />
 *
 * names the visible columns of a table in a spreadsheet.
 *
 * Only new displays are set, and axes only where none has been changed and nothing else is shown; later changes by the
 * user, and state files, stay. A render view stays active where a chart has been opened beside it by Apply: what is
 * applied next would else find no place in the chart.
 */
class ChartDisplay
{
public:
  explicit ChartDisplay(vtkSMSourceProxy* owner)
    : Owner(owner)
  {
  }
  ~ChartDisplay();
  ChartDisplay(const ChartDisplay&) = delete;
  void operator=(const ChartDisplay&) = delete;

  /// Starts to follow the session; called when the owner has one.
  void Watch();

private:
  /// A column of the table and how it is drawn.
  struct Series
  {
    std::string Name;
    std::string Label;
    std::string Style; ///< name of the element: Points, Lines or Bars
    int Color;         ///< index of the palette
    int LineStyle;     ///< of vtkPen
  };
  /// A chart with the series that it has been given.
  struct Chart
  {
    vtkWeakPointer<vtkSMProxy> Representation;
    int Port;
    std::vector<std::string> Names;
  };

  vtkPVXMLElement* Hint(const char* name, int port);
  std::vector<std::string> TextsOf(const char* column, int port, int count);
  std::vector<Series> SeriesOf(vtkPVXMLElement* hint);
  void OnRegister(vtkObject*, unsigned long, void* information);
  void OnData(vtkObject*, unsigned long, void*);
  void OnView(vtkObject* object, unsigned long, void*);
  void OnPicture(vtkObject* object, unsigned long, void*);
  void DrawSeries(vtkSMProxy* representation, vtkPVXMLElement* hint, const std::vector<Series>& series);
  void SetAxes(vtkSMProxy* view, vtkPVXMLElement* hint);
  void HideColumns(vtkSMProxy* view, vtkPVXMLElement* hint, int port);
  void WaitForView(vtkSMProxy* representation, int port);
  vtkSMProxy* ActiveView();

  vtkSMSourceProxy* Owner;
  vtkWeakPointer<vtkSMSessionProxyManager> Manager;
  unsigned long RegisterObserver = 0;
  unsigned long DataObserver = 0;
  std::vector<Chart> Charts;
  vtkWeakPointer<vtkSMProxy> Homeless; ///< representation that is about to be added to a view
  int HomelessPort = 0;
  std::vector<Observation> Views;        ///< to one of which it will be added
  std::vector<Observation> Pictures;     ///< first pictures of opened views
  vtkWeakPointer<vtkSMProxy> FormerView; ///< render view to return to
};

}

#endif
