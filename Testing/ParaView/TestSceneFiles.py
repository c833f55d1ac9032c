# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""SaveData writes scenes of glTF: a forest as instances, a group of sources, the motion of kelp, properties of the panel."""
import json
import os
import struct
import sys

import quick  # noqa: F401
from paraview import servermanager, simple

if not hasattr(servermanager.writers, "GLTFSceneWriter"):
    print("built without tinygltf")
    sys.exit(125)


def saved(name, proxy, **options):
    """The JSON of a file that SaveData writes."""
    if os.path.exists(name):
        os.remove(name)
    simple.SaveData(name, proxy=proxy, **options)
    with open(name, "rb") as file:
        data = file.read()
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


sites = simple.QuadratPoints(Quadrats=[4, 4])
tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)
forest = simple.PlantScatter(Sites=sites, Prototypes=[tree], OutputForm="Instances", UseCulling=0, FollowCamera=0)
forest.UpdatePipeline()
factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
factory.UpdateAvailableWriters()
assert "glTF scenes of Littoral(*.glb" in factory.GetSupportedFileTypes(forest.SMProxy, 0)
scene = saved("forest.glb", forest, SceneName="Wood", WriteSun=1, SunDirection=[1.0, 0.0, 1.0])
assert "EXT_mesh_gpu_instancing" in scene["extensionsUsed"] and "MSFT_lod" in scene["extensionsUsed"]
assert scene["scenes"][0]["name"] == "Wood" and any(node["name"] == "Sun" for node in scene["nodes"])
count = forest.FieldData.GetArray("PlantsShown").GetRange()[0]
nodes = saved("nodes.glb", forest, InstanceForm="Nodes", LevelForm="Low")
assert sum("scale" in node or "rotation" in node for node in nodes["nodes"]) >= count, "there is no node for each plant"

land = simple.TurningBandsTerrain(WholeExtent=[0, 20, 0, 20, 0, 0])
both = simple.GroupDatasets(Input=[land, tree])
both.UpdatePipeline()
group = saved("group.glb", both)
assert {material["extras"]["kind"] for material in group["materials"]} >= {"ground", "bark", "leaf"}

kelp = simple.SeaweedDeformation(Input=simple.Seaweed(SegmentsPerBranch=4), SeaState=simple.SeaState(SeaLevel=4.0),
                                 GenerateJoints=1, UseLevels=0, FollowCamera=0)
kelp.UpdatePipeline()
moving = saved("kelp.glb", kelp, WriteMotion=1, EndTime=0.5, FramesPerSecond=10.0, JointTolerance=0.0)
assert moving["skins"] and moving["accessors"][moving["animations"][0]["samplers"][0]["input"]]["count"] == 6
print("done")
