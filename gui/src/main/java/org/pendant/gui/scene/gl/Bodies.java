package org.pendant.gui.scene.gl;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.pendant.controller.world.Scene;
import org.pendant.gui.scene.SceneModel;
import org.pendant.gui.scene.mesh.ArmMeshes;
import org.pendant.gui.scene.mesh.Link;
import org.pendant.gui.scene.mesh.Marks;
import org.pendant.gui.scene.mesh.WorldMesh;
import org.pendant.models.shape.ArmShapes;

/** The meshes of a model in the memory of the graphics, made again when they have to be. */
final class Bodies implements AutoCloseable {
  private static final double ROD_RADIUS_M = 0.004;

  private final GpuMesh frame = new GpuMesh(List.of(Marks.frame()));
  private final GpuMesh rod = new GpuMesh(List.of(Marks.rod(ROD_RADIUS_M)));
  private String armId = "";
  private ArmMeshes armMeshes;
  private GpuMesh arm = new GpuMesh(List.of());
  private Scene scene = Scene.EMPTY;
  private Set<String> touched = Set.of();
  private GpuMesh world = new GpuMesh(List.of());

  /** Has what this model needs. */
  void load(SceneModel model) {
    if (!armId.equals(model.arm().id())) {
      armId = model.arm().id();
      armMeshes = new ArmMeshes(ArmShapes.load(armId), model.arm().dh());
      arm.close();
      arm = new GpuMesh(Arrays.stream(Link.values()).map(armMeshes::of).toList());
    }
    if (!scene.equals(model.world()) || !touched.equals(model.touched())) {
      scene = model.world();
      touched = model.touched();
      world.close();
      world = new GpuMesh(List.of(WorldMesh.of(scene.objects(), touched)));
    }
  }

  /** The meshes of the arm that was loaded last. */
  ArmMeshes armMeshes() {
    return armMeshes;
  }

  /** The arm, one place for each link. */
  GpuMesh arm() {
    return arm;
  }

  /** Boxes and balls, in place 0. */
  GpuMesh world() {
    return world;
  }

  /** Arrows of length 1, in place 0. */
  GpuMesh frame() {
    return frame;
  }

  /** A rod of length 1 along z, in place 0. */
  GpuMesh rod() {
    return rod;
  }

  @Override
  public void close() {
    arm.close();
    world.close();
    frame.close();
    rod.close();
  }
}
