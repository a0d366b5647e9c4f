// Surfaces that stay visible: a rim around every bar and mark, and hatching for what is not known for sure.

import { BackSide, Color, InstancedBufferAttribute, InstancedMesh, MeshBasicMaterial, MeshLambertMaterial, Vector2 } from "three";

const RIM = [0.35, 1.2]; // least and largest width of a rim, CSS pixels
const PITCH = "5.0"; // of stripes, of the radius of a bar
const SHARE = 0.6; // width of a rim over the radius of a bar as it is seen

/** A lit material whose instances are striped along their y axis where their `hatch` is 1; stripes have the colour of the background. */
export function hatchable() {
  const material = new MeshLambertMaterial({ color: "#ffffff" });
  material.userData = { stripe: { value: new Color() } };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, material.userData);
    shader.vertexShader = `attribute float hatch;\nvarying float vHatch;\nvarying float vAlong;\n${shader.vertexShader}`.replace("#include <begin_vertex>", `#include <begin_vertex>
      vHatch = hatch;
      vAlong = position.y * length(instanceMatrix[1].xyz) / (${PITCH} * max(length(instanceMatrix[0].xyz), length(instanceMatrix[2].xyz)));`);
    shader.fragmentShader = `varying float vHatch;\nvarying float vAlong;\nuniform vec3 stripe;\n${shader.fragmentShader}`.replace("#include <color_fragment>",
      "#include <color_fragment>\nif (vHatch > 0.5 && fract(vAlong) < 0.4) diffuseColor.rgb = stripe;");
  };
  return material;
}

/** Room for the hatch of each instance of a mesh. */
export function withHatch(mesh) {
  mesh.material = hatchable();
  mesh.geometry.setAttribute("hatch", new InstancedBufferAttribute(new Float32Array(mesh.instanceMatrix.count), 1));
  return mesh;
}

/** Rims of instanced meshes: their back sides, wider by the same number of pixels at any distance. */
export class Rims {
  /** long : of the meshes those of bars, whose ends have no rim: pieces of a curve meet there. */
  constructor(meshes, long = []) {
    this.size = { value: new Vector2(1, 1) };
    this.width = { value: RIM[1] };
    [this.material, this.sides] = ["", "if (abs(normal.y) > 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);"].map((more) => this.outline(more));
    this.meshes = meshes.filter((mesh) => mesh.count).map((mesh) => {
      const rim = new InstancedMesh(mesh.geometry, long.includes(mesh) ? this.sides : this.material, mesh.count);
      rim.instanceMatrix = mesh.instanceMatrix;
      rim.frustumCulled = false;
      return rim;
    });
  }

  /** Back sides moved outwards along their normals; more : a further line of the shader. */
  outline(more) {
    const material = new MeshBasicMaterial({ side: BackSide });
    material.customProgramCacheKey = () => `rim ${more}`;
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, { rimSize: this.size, rimWidth: this.width });
      shader.vertexShader = `uniform vec2 rimSize;\nuniform float rimWidth;\n${shader.vertexShader}`.replace("#include <project_vertex>", `#include <project_vertex>
        vec3 rimNormal = mat3(modelViewMatrix) * mat3(instanceMatrix) * normal;
        vec2 rimAway = (projectionMatrix * vec4(rimNormal, 0.0)).xy * rimSize;
        gl_Position.xy += rimAway / max(length(rimAway), 1e-20) * 2.0 * rimWidth / rimSize * gl_Position.w;
        ${more}`);
    };
    return material;
  }

  setColour(hex) {
    for (const material of [this.material, this.sides]) material.color.set(hex);
  }

  /** radius : of the usual bar, CSS pixels: rims of bars seen from afar are thinner, or only they would be seen. */
  setScale(radius) {
    this.width.value = Math.min(Math.max(SHARE * radius, RIM[0]), RIM[1]);
  }

  resize(width, height) {
    this.size.value.set(width, height);
  }
}
