package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Scene;
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
    List<OtherArm> others) {

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
        List.of());
  }

  /** The arm as a snapshot of the controller has it, with its active tool centre point. */
  public SceneModel at(ArmState state) {
    return new SceneModel(
        arm,
        state.kinematics(),
        state.actualPositionRad(),
        ghostRad,
        state.tool().inFlange(),
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
        others);
  }

  public SceneModel withGhost(Optional<Joints> positionOfGhostRad) {
    return new SceneModel(
        arm,
        kinematics,
        positionRad,
        positionOfGhostRad,
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
        others);
  }

  public SceneModel withTool(Pose tcp) {
    return new SceneModel(
        arm,
        kinematics,
        positionRad,
        ghostRad,
        tcp,
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
        others);
  }

  public SceneModel withFrames(List<Pose> frames) {
    return new SceneModel(
        arm,
        kinematics,
        positionRad,
        ghostRad,
        tcpInFlange,
        frames,
        payload,
        world,
        touched,
        trace,
        theme,
        waypointMarkers,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withPayload(Optional<Ball> ball) {
    return new SceneModel(
        arm,
        kinematics,
        positionRad,
        ghostRad,
        tcpInFlange,
        framesInBase,
        ball,
        world,
        touched,
        trace,
        theme,
        waypointMarkers,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withWorld(Scene surroundings, Set<String> touchedNames) {
    return new SceneModel(
        arm,
        kinematics,
        positionRad,
        ghostRad,
        tcpInFlange,
        framesInBase,
        payload,
        surroundings,
        touchedNames,
        trace,
        theme,
        waypointMarkers,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withTrace(TcpTrace way) {
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
        way,
        theme,
        waypointMarkers,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withTheme(SceneTheme colours) {
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
        colours,
        waypointMarkers,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withWaymarks(WaypointMarkers marks) {
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
        marks,
        safety,
        compared,
        devices,
        others);
  }

  public SceneModel withSafety(SafetySight sight) {
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
        sight,
        compared,
        devices,
        others);
  }

  public SceneModel withDevices(DeviceSight sight) {
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
        sight,
        others);
  }

  public SceneModel withOthers(List<OtherArm> arms) {
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
        arms);
  }

  /** Pose of the tool centre point in the base frame. */
  public Pose tcpInBase() {
    return kinematics.tcpPose(positionRad, tcpInFlange);
  }
}
