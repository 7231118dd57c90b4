package org.pendant.desktop.scene.gl;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Matrix4f;
import org.pendant.controller.world.GripperSetup;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.LinkPlaces;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.mesh.ArmMeshes;
import org.pendant.desktop.scene.mesh.Detail;
import org.pendant.desktop.scene.mesh.GripperMesh;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.desktop.scene.mesh.Marks;
import org.pendant.desktop.scene.mesh.Mesh;
import org.pendant.desktop.scene.mesh.WorldMesh;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.pose.Pose;
import org.pendant.models.shape.ArmShapes;

/** Bodies: the meshes of a model in the memory of the graphics, made again when they have to be. */
final class Bodies implements AutoCloseable {
  private static final double ROD_RADIUS_M = 0.004;

  private final Detail detail;
  private final GpuMesh frame;
  private final GpuMesh rod;
  private final GpuMesh ball;
  private String armId = "";

  /** The arm and the others of the cell, by their ids. */
  private final Map<String, LoadedArm> arms = new HashMap<>();

  private Scene scene = Scene.EMPTY;
  private Set<String> touched = Set.of();
  private Mesh.Box worldBox = new Mesh.Box(0, 0, 0, -1, -1, -1);
  private GpuMesh world = new GpuMesh(List.of());
  private final List<LoadedGripper> grippers = new ArrayList<>();

  /** The grippers of other arms. */
  private final Map<GripperOf, LoadedGripper> others = new HashMap<>();

  /** The bodies on the flanges of all arms. */
  private final Map<List<SceneObject>, LoadedTool> tools = new HashMap<>();

  /** An arm in the memory of the graphics, and how far its links reach. */
  private record LoadedArm(ArmMeshes meshes, Map<Link, Mesh.Box> boxes, GpuMesh mesh) {}

  /** A gripper in the memory of the graphics, and how far its meshes reach. */
  private record LoadedGripper(GripperOf of, List<Mesh.Box> boxes, GpuMesh mesh) {}

  /** Bodies on a flange in the memory of the graphics, and how far they reach. */
  private record LoadedTool(Mesh.Box box, GpuMesh mesh) {}

  private record GripperOf(GripperSetup.Grip grip, double reachM, double strokeM, boolean holds) {
    static GripperOf of(DeviceSight.Gripper sight, Pose tcpInFlange) {
      return new GripperOf(
          sight.gripper().grip(), sight.inFlange(tcpInFlange).z(), sight.strokeM(), sight.holds());
    }

    List<Mesh> meshes(Detail detail) {
      return GripperMesh.of(grip, reachM, strokeM, holds, detail);
    }
  }

  /**
   * @param detail how finely they are cut
   */
  Bodies(Detail detail) {
    this.detail = detail;
    frame = new GpuMesh(List.of(Marks.frame(detail)));
    rod = new GpuMesh(List.of(Marks.rod(ROD_RADIUS_M, detail)));
    ball = new GpuMesh(List.of(Marks.ball(detail)));
  }

  /** Has what this model needs. */
  void load(SceneModel model) {
    armId = model.arm().id();
    Set<String> ids = new HashSet<>(Set.of(armId));
    model.others().forEach(each -> ids.add(each.arm().id()));
    arms.entrySet()
        .removeIf(
            each -> {
              boolean gone = !ids.contains(each.getKey());
              if (gone) {
                each.getValue().mesh.close();
              }
              return gone;
            });
    load(model.arm());
    model.others().forEach(each -> load(each.arm()));
    if (!scene.equals(model.world()) || !touched.equals(model.touched())) {
      scene = model.world();
      touched = model.touched();
      Mesh mesh = WorldMesh.of(scene.objects(), touched, detail);
      worldBox = mesh.box();
      world.close();
      world = new GpuMesh(List.of(mesh));
    }
    List<GripperOf> wanted =
        model.devices().grippers().stream()
            .map(sight -> GripperOf.of(sight, model.tcpInFlange()))
            .toList();
    if (!wanted.equals(grippers.stream().map(LoadedGripper::of).toList())) {
      grippers.forEach(each -> each.mesh.close());
      grippers.clear();
      wanted.forEach(each -> grippers.add(load(each)));
    }
    loadGrippers(model.others());
    loadTools(model);
  }

  private void loadTools(SceneModel model) {
    Set<List<SceneObject>> wanted = new HashSet<>();
    wanted.add(model.world().toolBodies());
    model.others().forEach(each -> wanted.add(each.toolBodies()));
    tools
        .entrySet()
        .removeIf(
            each -> {
              boolean gone = !wanted.contains(each.getKey());
              if (gone) {
                each.getValue().mesh.close();
              }
              return gone;
            });
    for (List<SceneObject> each : wanted) {
      tools.computeIfAbsent(
          each,
          objects -> {
            Mesh mesh = WorldMesh.of(objects, Set.of(), detail);
            return new LoadedTool(mesh.box(), new GpuMesh(List.of(mesh)));
          });
    }
  }

  private void load(ArmDescription arm) {
    arms.computeIfAbsent(
        arm.id(),
        id -> {
          ArmMeshes meshes = new ArmMeshes(ArmShapes.load(id), arm.dh(), detail);
          Map<Link, Mesh.Box> boxes = new EnumMap<>(Link.class);
          for (Link link : Link.values()) {
            boxes.put(link, meshes.of(link).box());
          }
          return new LoadedArm(
              meshes, boxes, new GpuMesh(Arrays.stream(Link.values()).map(meshes::of).toList()));
        });
  }

  private LoadedGripper load(GripperOf of) {
    List<Mesh> meshes = of.meshes(detail);
    return new LoadedGripper(of, meshes.stream().map(Mesh::box).toList(), new GpuMesh(meshes));
  }

  private void loadGrippers(List<OtherArm> arms) {
    Set<GripperOf> wanted = new HashSet<>();
    for (OtherArm each : arms) {
      each.grippers().forEach(sight -> wanted.add(GripperOf.of(sight, each.tcpInFlange())));
    }
    others
        .values()
        .removeIf(
            each -> {
              boolean gone = !wanted.contains(each.of);
              if (gone) {
                each.mesh.close();
              }
              return gone;
            });
    wanted.forEach(each -> others.computeIfAbsent(each, this::load));
  }

  /**
   * Counts all that throws a shadow.
   *
   * @param gripperPlaces of the meshes of each gripper
   */
  void addTo(ShadowReach reach, LinkPlaces places, List<List<Matrix4f>> gripperPlaces) {
    addTo(reach, arms.get(armId), places);
    reach.add(tools.get(scene.toolBodies()).box, places.of(Link.WRIST_3));
    reach.add(worldBox, new Matrix4f());
    for (int i = 0; i < gripperPlaces.size(); i++) {
      List<Mesh.Box> boxes = grippers.get(i).boxes;
      for (int j = 0; j < boxes.size(); j++) {
        reach.add(boxes.get(j), gripperPlaces.get(i).get(j));
      }
    }
  }

  /** As the other one, of another arm. */
  void addTo(
      ShadowReach reach, OtherArm other, LinkPlaces places, List<List<Matrix4f>> gripperPlaces) {
    addTo(reach, arms.get(other.arm().id()), places);
    reach.add(tools.get(other.toolBodies()).box, places.of(Link.WRIST_3));
    for (int i = 0; i < gripperPlaces.size(); i++) {
      List<Mesh.Box> boxes = loaded(other, i).boxes;
      for (int j = 0; j < boxes.size(); j++) {
        reach.add(boxes.get(j), gripperPlaces.get(i).get(j));
      }
    }
  }

  private static void addTo(ShadowReach reach, LoadedArm arm, LinkPlaces places) {
    for (Link link : Link.values()) {
      reach.add(arm.boxes.get(link), places.of(link));
    }
  }

  private LoadedGripper loaded(OtherArm other, int number) {
    return others.get(GripperOf.of(other.grippers().get(number), other.tcpInFlange()));
  }

  /** The meshes of the arm that was loaded last. */
  ArmMeshes armMeshes() {
    return arms.get(armId).meshes;
  }

  /** The arm, one place for each link. */
  GpuMesh arm() {
    return arms.get(armId).mesh;
  }

  /** Another arm, one place for each link. */
  GpuMesh arm(OtherArm other) {
    return arms.get(other.arm().id()).mesh;
  }

  /** A gripper of another arm, one place for each of its meshes. */
  GpuMesh gripper(OtherArm other, int number) {
    return loaded(other, number).mesh;
  }

  /** Boxes and balls, in place 0. */
  GpuMesh world() {
    return world;
  }

  /** Bodies on a flange, in place 0. */
  GpuMesh tool(List<SceneObject> toolBodies) {
    return tools.get(toolBodies).mesh;
  }

  /** A gripper, one place for each of its meshes. */
  GpuMesh gripper(int number) {
    return grippers.get(number).mesh;
  }

  /** Arrows of length 1, in place 0. */
  GpuMesh frame() {
    return frame;
  }

  /** A rod of length 1 along z, in place 0. */
  GpuMesh rod() {
    return rod;
  }

  /** A ball of radius 1, in place 0. */
  GpuMesh ball() {
    return ball;
  }

  @Override
  public void close() {
    arms.values().forEach(each -> each.mesh.close());
    others.values().forEach(each -> each.mesh.close());
    tools.values().forEach(each -> each.mesh.close());
    world.close();
    grippers.forEach(each -> each.mesh.close());
    frame.close();
    rod.close();
    ball.close();
  }
}
