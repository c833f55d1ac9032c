// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What three.js has of a scene file, as JSON: node three_scene.mjs FOLDER_OF_THREE FILE.glb [TIME...]
import fs from 'node:fs';

const [folder, file, ...times] = process.argv.slice(2);
// The loader wants a browser's pictures: the size of a PNG is enough.
globalThis.self = globalThis;
globalThis.createImageBitmap = async (blob) => {
  const bytes = Buffer.from(await blob.arrayBuffer());
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20), close() {} };
};
const THREE = await import(`${folder}/build/three.module.js`);
const { GLTFLoader } = await import(`${folder}/examples/jsm/loaders/GLTFLoader.js`);

const bytes = fs.readFileSync(file);
const whole = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const scene = await new Promise((resolve, reject) => new GLTFLoader().parse(whole, '', resolve, reject));

/** World places of all vertices, of all instances. */
function placesOf(mesh) {
  const places = [], place = new THREE.Vector3(), own = new THREE.Matrix4();
  for (let instance = 0; instance < (mesh.isInstancedMesh ? mesh.count : 1); ++instance) {
    own.copy(mesh.matrixWorld);
    if (mesh.isInstancedMesh) {
      const matrix = new THREE.Matrix4();
      mesh.getMatrixAt(instance, matrix);
      own.multiply(matrix);
    }
    for (let vertex = 0; vertex < mesh.geometry.attributes.position.count; ++vertex) {
      mesh.getVertexPosition(vertex, place).applyMatrix4(own);
      places.push(place.x, place.y, place.z);
    }
  }
  return places;
}

/** The numbers of an attribute, those of integers from 0 to 1. */
function numbersOf(attribute) {
  const numbers = [];
  for (let vertex = 0; vertex < attribute.count; ++vertex) {
    for (let part = 0; part < attribute.itemSize; ++part) {
      numbers.push(attribute.getComponent(vertex, part));
    }
  }
  return numbers;
}

function pathOf(thing) {
  return thing.parent && thing.parent !== scene.scene ? `${pathOf(thing.parent)}/${thing.name}` : thing.name;
}

function look(isFirst) {
  const found = [];
  scene.scene.updateMatrixWorld(true);
  scene.scene.traverse((thing) => {
    if (!thing.isMesh && !thing.isPoints && !thing.isLine) {
      return;
    }
    thing.skeleton?.update();
    const geometry = thing.geometry, material = thing.material;
    const about = { path: pathOf(thing), places: thing.isMesh ? placesOf(thing) : Array.from(geometry.attributes.position.array) };
    if (isFirst) {
      Object.assign(about, {
        type: thing.type, instances: thing.isInstancedMesh ? thing.count : 1,
        corners: geometry.index ? geometry.index.count : geometry.attributes.position.count,
        colors: geometry.attributes.color ? numbersOf(geometry.attributes.color) : null,
        attributes: Object.keys(geometry.attributes), kind: material.userData.kind, alphaTest: material.alphaTest,
        double: material.side === THREE.DoubleSide, picture: material.map ? [material.map.image.width, material.map.image.height] : null,
        rests: thing.isSkinnedMesh ? thing.skeleton.boneInverses.flatMap((m) => m.elements.slice(12, 15)) : null,
      });
    }
    found.push(about);
  });
  return found;
}

const out = { meshes: look(true), times: [], cameras: scene.cameras.map((camera) => camera.fov), lights: [] };
scene.scene.traverse((thing) => thing.isLight && out.lights.push([thing.type, thing.intensity]));
for (const time of times) {
  const mixer = new THREE.AnimationMixer(scene.scene);
  scene.animations.forEach((clip) => mixer.clipAction(clip).setLoop(THREE.LoopOnce, 1).play());
  scene.animations.forEach((clip) => { mixer.clipAction(clip).clampWhenFinished = true; });
  mixer.setTime(Number(time));
  out.times.push(look(false));
}
fs.writeSync(1, JSON.stringify(out));
