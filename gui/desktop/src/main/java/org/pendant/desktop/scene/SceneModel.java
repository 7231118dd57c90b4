package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.scene.mesh.FloorGrid;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/**
 * Scene model: what there is to see at one instant. Immutable; two that are equal look the same.
 *
 * @param arm the arm; its shape is known by its id
 * @param kinematics of this very arm, calibration included
 * @param positionRad where its joints are, rad
 * @param ghostRad where a translucent second arm is, rad: a target or a preview
 * @param tcpInFlange the tool centre point, m and rad
 * @param framesInBase frames to draw besides those of the base and the tool centre point
 * @param payload a ball as heavy as what programs have declared to hang on the flange, around its
 *     centre of gravity; empty for none to draw
 * @param world what stands around the arm
 * @param touched names of the objects of the world that the tool touches
 * @param trace where the tool centre point has been
 * @param theme colours
 * @param waypointMarkers the places that a program goes to
 * @param safety what is to be seen of the safety functions
 * @param compared ways of the tool in variants of a run
 * @param devices what is to be seen of the devices of the cell
 * @param others the other arms of the cell
 * @param grid the lines on the floor and on planes
 */
public record SceneModel(
    ArmDescription arm,
    ForwardKinematics kinematics,
    Joints positionRad,
    Optional<Joints> ghostRad,
    Pose tcpInFlange,
    List<Pose> framesInBase,
    Optional<Ball> payload,
    Scene world,
    Set<String> touched,
    TcpTrace trace,
    SceneTheme theme,
    WaypointMarkers waypointMarkers,
    SafetySight safety,
    ComparedWays compared,
    DeviceSight devices,
    List<OtherArm> others,
    FloorGrid grid) {

  /** Copies the collections. */
  public SceneModel {
    framesInBase = List.copyOf(framesInBase);
    touched = Set.copyOf(touched);
    others = List.copyOf(others);
  }

  /** An arm alone, its tool centre point on the flange. */
  public static SceneModel of(ArmDescription arm, Joints positionRad) {
    return new SceneModel(
        arm,
        new ForwardKinematics(arm),
        positionRad,
        Optional.empty(),
        Pose.ZERO,
        List.of(),
        Optional.empty(),
        Scene.EMPTY,
        Set.of(),
        TcpTrace.EMPTY,
        SceneTheme.LIGHT,
        WaypointMarkers.NONE,
        SafetySight.NONE,
        ComparedWays.NONE,
        DeviceSight.NONE,
        List.of(),
        FloorGrid.METRES);
  }

  /** The arm as a snapshot of the controller has it, with its active tool centre point. */
  public SceneModel at(ArmState state) {
    return with(
        parts -> {
          parts.kinematics = state.kinematics();
          parts.positionRad = state.actualPositionRad();
          parts.tcpInFlange = state.tool().inFlange();
        });
  }

  public SceneModel withGhost(Optional<Joints> positionOfGhostRad) {
    return with(parts -> parts.ghostRad = positionOfGhostRad);
  }

  public SceneModel withTool(Pose tcp) {
    return with(parts -> parts.tcpInFlange = tcp);
  }

  public SceneModel withFrames(List<Pose> frames) {
    return with(parts -> parts.framesInBase = frames);
  }

  public SceneModel withPayload(Optional<Ball> ball) {
    return with(parts -> parts.payload = ball);
  }

  public SceneModel withWorld(Scene surroundings, Set<String> touchedNames) {
    return with(
        parts -> {
          parts.world = surroundings;
          parts.touched = touchedNames;
        });
  }

  public SceneModel withTrace(TcpTrace way) {
    return with(parts -> parts.trace = way);
  }

  public SceneModel withTheme(SceneTheme colours) {
    return with(parts -> parts.theme = colours);
  }

  public SceneModel withWaymarks(WaypointMarkers marks) {
    return with(parts -> parts.waypointMarkers = marks);
  }

  public SceneModel withSafety(SafetySight sight) {
    return with(parts -> parts.safety = sight);
  }

  public SceneModel withDevices(DeviceSight sight) {
    return with(parts -> parts.devices = sight);
  }

  public SceneModel withOthers(List<OtherArm> arms) {
    return with(parts -> parts.others = arms);
  }

  public SceneModel withGrid(FloorGrid lines) {
    return with(parts -> parts.grid = lines);
  }

  /** Pose of the tool centre point in the base frame. */
  public Pose tcpInBase() {
    return kinematics.tcpPose(positionRad, tcpInFlange);
  }

  private SceneModel with(Consumer<Parts> change) {
    Parts parts = new Parts(this);
    change.accept(parts);
    return parts.model();
  }

  /** The parts of a model that is being made from another. */
  private static final class Parts {
    private final ArmDescription arm;
    private ForwardKinematics kinematics;
    private Joints positionRad;
    private Optional<Joints> ghostRad;
    private Pose tcpInFlange;
    private List<Pose> framesInBase;
    private Optional<Ball> payload;
    private Scene world;
    private Set<String> touched;
    private TcpTrace trace;
    private SceneTheme theme;
    private WaypointMarkers waypointMarkers;
    private SafetySight safety;
    private ComparedWays compared;
    private DeviceSight devices;
    private List<OtherArm> others;
    private FloorGrid grid;

    Parts(SceneModel of) {
      arm = of.arm;
      kinematics = of.kinematics;
      positionRad = of.positionRad;
      ghostRad = of.ghostRad;
      tcpInFlange = of.tcpInFlange;
      framesInBase = of.framesInBase;
      payload = of.payload;
      world = of.world;
      touched = of.touched;
      trace = of.trace;
      theme = of.theme;
      waypointMarkers = of.waypointMarkers;
      safety = of.safety;
      compared = of.compared;
      devices = of.devices;
      others = of.others;
      grid = of.grid;
    }

    SceneModel model() {
      return new SceneModel(
          arm,
          kinematics,
          positionRad,
          ghostRad,
          tcpInFlange,
          framesInBase,
          payload,
          world,
          touched,
          trace,
          theme,
          waypointMarkers,
          safety,
          compared,
          devices,
          others,
          grid);
    }
  }
}
