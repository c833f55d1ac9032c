// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGLTFSceneWriter
 * @brief   write landscapes as a glTF 2.0 scene (.glb)
 *
 * Inputs: any number of sources at port 0, each a vtkPolyData, a vtkImageData that is a terrain (one layer with the
 * point array `Elevation` [m] or else active scalars), or blocks of them (vtkMultiBlockDataSet, or
 * vtkPartitionedDataSetCollection whose parts are each in one partition): plants, scattered forests, terrains, seas,
 * particles, and data of other programs.
 *
 * The file has one scene in meters. Its root node turns z up into the y up of glTF; below it is a node for each source
 * with its name, and below that one for each block with points. A block becomes a mesh: triangles, lines and points
 * with normals, texture coordinates, the colors `RGB` (bytes; else the active scalars, if they are bytes of three or
 * four components) as linear colors, `_RADIUS` from `Radius` [m] where there are no polygons, and `_VELOCITY` if
 * WriteVelocity is on. The picture in the field data `Texture` and `TextureSize` is embedded as PNG and cut out where
 * its alpha is below a half; the colors are divided by `TextureMean`. Skeletons of plants are not drawn.
 *
 * The extra `kind` of a material is bark, leaf, grass, blade (of a seaweed), ground, water, particle, sky or plain. It
 * is told by the data: blocks of plants by their names, others by the point arrays `Jacobian` (water), `ParticleId` and
 * `Elevation`; SetSourceKind() overrides that.
 *
 * Instances of vtkPlantScatterFilter are written as InstanceForm says, levels of detail of them and of single plants as
 * LevelForm says. Merged forests are written as they are. Tints are factors of displayed colors; those in the file, for
 * linear light, are their power 2.2.
 *
 * The file is written under another name in the same folder and renamed when it is complete. Bad input is reported as
 * one error before anything is written: Write() returns 0, and an existing file of this name is unchanged. The same
 * input gives the same bytes. A file has at most 4.29 GB. Blocks on other ranks than the first are not written.
 *
 * @sa vtkVDBVolumeWriter vtkPlantScatterFilter
 */
#ifndef vtkGLTFSceneWriter_h
#define vtkGLTFSceneWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSingleFileWriter.h"

#include <map>    // for names and kinds
#include <memory> // for the scene
#include <string> // for names
#include <vector> // for sources

namespace littoral
{
struct SceneOptions;
struct SceneSource;
}

class LITTORALIO_EXPORT vtkGLTFSceneWriter : public vtkSingleFileWriter
{
public:
  static vtkGLTFSceneWriter* New();
  vtkTypeMacro(vtkGLTFSceneWriter, vtkSingleFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the scene and of its root node, in UTF-8; default `Scene`.
   */
  vtkSetMacro(SceneName, std::string);
  vtkGetMacro(SceneName, std::string);
  ///@}

  ///@{
  /**
   * Name of a source by the index of its connection, in UTF-8; default `Source 0`, `Source 1` and so on.
   */
  void SetSourceName(int source, const std::string& name);
  std::string GetSourceName(int source);
  ///@}

  enum KindType
  {
    Automatic = 0,
    Bark = 1,
    Leaf = 2,
    Grass = 3,
    Blade = 4,
    Ground = 5,
    Water = 6,
    Particle = 7,
    Sky = 8,
    Plain = 9
  };

  ///@{
  /**
   * Kind of all materials of a source by the index of its connection, a KindType; default Automatic, as the data tell.
   */
  void SetSourceKind(int source, int kind);
  int GetSourceKind(int source);
  ///@}

  /**
   * Removes the names and kinds of all sources.
   */
  void ClearSources();

  enum InstanceFormType
  {
    GpuInstancing = 0,
    Nodes = 1
  };

  ///@{
  /**
   * Form of instances, an InstanceFormType; default GpuInstancing. GpuInstancing: a node for each part of each level,
   * with the places of all plants by the extension EXT_mesh_gpu_instancing and their tints as attribute `_TINT`; a
   * reader without the extension shows one plant at the origin. Nodes: a node for each plant, with the extra `tint`,
   * which any reader shows; 100 000 plants take some 100 MB.
   */
  vtkSetMacro(InstanceForm, int);
  vtkGetMacro(InstanceForm, int);
  void SetInstanceFormToGpuInstancing() { this->SetInstanceForm(GpuInstancing); }
  void SetInstanceFormToNodes() { this->SetInstanceForm(Nodes); }
  ///@}

  enum LevelFormType
  {
    Switched = 0,
    AsShown = 1,
    High = 2,
    Medium = 3,
    Low = 4
  };

  ///@{
  /**
   * Levels of detail of instances and single plants, a LevelFormType; default Switched. Switched: each plant at all
   * levels, High with the others behind it by the extension MSFT_lod; a reader without it shows High. AsShown:
   * instances at the levels that they have in the input, single plants at High. High, Medium, Low: all at that level.
   */
  vtkSetMacro(LevelForm, int);
  vtkGetMacro(LevelForm, int);
  void SetLevelFormToSwitched() { this->SetLevelForm(Switched); }
  void SetLevelFormToAsShown() { this->SetLevelForm(AsShown); }
  void SetLevelFormToHigh() { this->SetLevelForm(High); }
  void SetLevelFormToMedium() { this->SetLevelForm(Medium); }
  void SetLevelFormToLow() { this->SetLevelForm(Low); }
  ///@}

  ///@{
  /**
   * Writing of the point array `Velocity` [m/s] as the attribute `_VELOCITY` of vertices; default off.
   */
  vtkSetMacro(WriteVelocity, bool);
  vtkGetMacro(WriteVelocity, bool);
  vtkBooleanMacro(WriteVelocity, bool);
  ///@}

  ///@{
  /**
   * Writing of a perspective camera, with the position, focal point, view up and view angle below; default off.
   */
  vtkSetMacro(WriteCamera, bool);
  vtkGetMacro(WriteCamera, bool);
  vtkBooleanMacro(WriteCamera, bool);
  ///@}

  ///@{
  /**
   * Position of the camera [m]; default 0 0 1, as that of vtkCamera.
   */
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  ///@}

  ///@{
  /**
   * Point that the camera looks at [m], not its position; default 0 0 0.
   */
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  ///@}

  ///@{
  /**
   * Direction up in the picture, of any length but 0; default 0 1 0.
   */
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  ///@}

  ///@{
  /**
   * Vertical angle of view [degrees], above 0 and below 180; default 30.
   */
  vtkSetMacro(CameraViewAngle, double);
  vtkGetMacro(CameraViewAngle, double);
  ///@}

  ///@{
  /**
   * Writing of the sun as a directional light, by the extension KHR_lights_punctual; default off.
   */
  vtkSetMacro(WriteSun, bool);
  vtkGetMacro(WriteSun, bool);
  vtkBooleanMacro(WriteSun, bool);
  ///@}

  ///@{
  /**
   * Direction towards the sun, of any length but 0; default 0 0 1.
   */
  vtkSetVector3Macro(SunDirection, double);
  vtkGetVector3Macro(SunDirection, double);
  ///@}

  ///@{
  /**
   * Linear color of the sunlight, three parts from 0 to 1; default 1 1 1.
   */
  vtkSetVector3Macro(SunColor, double);
  vtkGetVector3Macro(SunColor, double);
  ///@}

  ///@{
  /**
   * Illuminance of a surface that faces the sun [lx], not negative; default 100000, that of a clear day.
   */
  vtkSetMacro(SunIlluminance, double);
  vtkGetMacro(SunIlluminance, double);
  ///@}

  ///@{
  /**
   * Extras of the scene, a JSON object: properties of water, fog, volumes and sky for renderers; default ``, none.
   * Empty objects and lists in it are left out.
   */
  vtkSetMacro(Extras, std::string);
  vtkGetMacro(Extras, std::string);
  ///@}

  ///@{
  /**
   * Writing of an animation: keyframes of the sources from StartTime to EndTime, FramesPerSecond a second, on a time
   * line that begins at 0 s; default off, the sources as they are. Plants with the block `Joints` (see
   * vtkBeamTreeDeformationFilter::SetGenerateJoints()) are skinned meshes, without the flutter of leaves; other
   * surfaces whose points move have morph targets. Colors, levels of detail and all else stay as they are at StartTime.
   */
  vtkSetMacro(WriteMotion, bool);
  vtkGetMacro(WriteMotion, bool);
  vtkBooleanMacro(WriteMotion, bool);
  ///@}

  ///@{
  /**
   * Start of the animation [s], any finite number; default 0.
   */
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /**
   * End of the animation [s], above StartTime; default 5. The last keyframe is the last one that is not later.
   */
  vtkSetMacro(EndTime, double);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * Keyframes of the animation a second, 0.01 to 1000; default 24.
   */
  vtkSetMacro(FramesPerSecond, double);
  vtkGetMacro(FramesPerSecond, double);
  ///@}

  ///@{
  /**
   * Largest error of skins in any keyframe [m], 0 to 10; default 0.001. A larger one needs fewer joints: a joint is
   * left out where another one moves its part of the skin within it. 0 keeps all joints.
   */
  vtkSetMacro(JointTolerance, double);
  vtkGetMacro(JointTolerance, double);
  ///@}

  /**
   * Writes the file; 0 where that fails, after a message.
   */
  int Write() override;

protected:
  vtkGLTFSceneWriter();
  ~vtkGLTFSceneWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  void WriteInput() override;

private:
  vtkGLTFSceneWriter(const vtkGLTFSceneWriter&) = delete;
  void operator=(const vtkGLTFSceneWriter&) = delete;

  std::string WhyInvalid() const;
  littoral::SceneOptions GetOptions() const;
  std::vector<littoral::SceneSource> GetSources();
  int GetNumberOfFrames() const;
  void Begin(const std::vector<littoral::SceneSource>& sources);
  void Follow(const std::vector<littoral::SceneSource>& sources);
  void WriteScene();
  void WriteFrame();
  void End();

  std::string SceneName = "Scene";
  std::map<int, std::string> SourceNames;
  std::map<int, int> SourceKinds;
  int InstanceForm = GpuInstancing;
  int LevelForm = Switched;
  bool WriteVelocity = false;
  bool WriteCamera = false;
  double CameraPosition[3] = { 0.0, 0.0, 1.0 };
  double CameraFocalPoint[3] = { 0.0, 0.0, 0.0 };
  double CameraViewUp[3] = { 0.0, 1.0, 0.0 };
  double CameraViewAngle = 30.0;
  bool WriteSun = false;
  double SunDirection[3] = { 0.0, 0.0, 1.0 };
  double SunColor[3] = { 1.0, 1.0, 1.0 };
  double SunIlluminance = 100000.0;
  std::string Extras;
  bool WriteMotion = false;
  double StartTime = 0.0;
  double EndTime = 5.0;
  double FramesPerSecond = 24.0;
  double JointTolerance = 0.001;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals; // the scene while it is read
  int Frame = 0;                           // of the motion
  bool IsStepping = false;                 // by Write()
};

#endif
