package org.pendant.desktop.shell;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SeenScene;
import org.pendant.desktop.scene.BeltTravel;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.session.CellSetup;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.StillArm;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Cell scene: all that the cell has around the arm in the picture: other arms, and the devices of
 * all controllers. The picture is in the frame of the base of the arm that the window shows; of the
 * first arm while that is the controller without one.
 */
final class CellScene {
  private final RobotSession session;
  private final BooleanSupplier ofFile;
  private final BeltTravel belts = new BeltTravel();
  private final Map<String, StillArm> stillArms = new HashMap<>();

  /**
   * @param ofFile whether people look at a recording of a file, which has one controller
   */
  CellScene(RobotSession session, BooleanSupplier ofFile) {
    this.session = session;
    this.ofFile = ofFile;
  }

  /** The controller of the arm in the picture. */
  SessionMember seen() {
    SessionMember shown = session.shown();
    return shown.armless() ? session.members().getFirst() : shown;
  }

  /**
   * What the controller of the arm in the picture publishes.
   *
   * @param ofShown a snapshot of the controller that the window shows
   * @param past whether that is of a moment that people look back at
   */
  ControllerState state(ControllerState ofShown, boolean past) {
    return session.shown().armless() ? state(seen(), ofShown, past) : ofShown;
  }

  /** Of the same frame where that is kept. */
  private static ControllerState state(SessionMember of, ControllerState at, boolean past) {
    return past ? of.recording().atFrame(at.frame()) : of.state();
  }

  /** A scene of the cell as it is seen in the picture. */
  Scene seenFromBase(Scene ofCell) {
    return SeenScene.of(ofCell, seen().baseInCell());
  }

  /** What the file of the cell says is around, in the frame of the picture, without what moved. */
  Scene real() {
    return seen().options().scene();
  }

  /** Whether a scene of the cell is just what was switched on. */
  boolean isReal(Scene ofCell) {
    return session
        .cell()
        .map(CellSetup::plan)
        .map(CellPlan::scene)
        .orElseGet(this::real)
        .equals(ofCell);
  }

  /** The other arms; none of a recording of a file. */
  List<OtherArm> others(ControllerState ofSeen, boolean past) {
    if (!session.inCell() || ofFile.getAsBoolean()) {
      return List.of();
    }
    SessionMember seen = seen();
    Pose cellInBase = Poses.inverse(seen.baseInCell());
    List<OtherArm> others = new ArrayList<>();
    for (SessionMember each : session.members()) {
      if (!each.armless() && !each.name().equals(seen.name())) {
        ControllerState state =
            stillArms
                .computeIfAbsent(each.name(), name -> new StillArm())
                .shown(state(each, ofSeen, past));
        others.add(
            new OtherArm(
                each.name(),
                state.arm().description(),
                state.arm().kinematics(),
                state.arm().actualPositionRad(),
                state.arm().tool().inFlange(),
                Poses.trans(cellInBase, each.baseInCell()),
                DeviceSight.of(each.options().equipment().devices(), state.devices(), false)
                    .grippers(),
                each.options().scene().toolBodies(),
                hit(each, state, ofSeen, past)));
      }
    }
    return others;
  }

  private List<String> hit(
      SessionMember arm, ControllerState state, ControllerState ofSeen, boolean past) {
    List<String> links =
        new ArrayList<>(state.safety().stop().map(SafetyStop::hitLinks).orElse(List.of()));
    links.addAll(hitByOthers(arm, ofSeen, past));
    return links;
  }

  /** The links of the arm in the picture that other arms have hit. */
  List<String> hitByOthers(ControllerState ofSeen, boolean past) {
    return session.inCell() && !ofFile.getAsBoolean()
        ? hitByOthers(seen(), ofSeen, past)
        : List.of();
  }

  private List<String> hitByOthers(SessionMember arm, ControllerState ofSeen, boolean past) {
    SessionMember seen = seen();
    List<String> links = new ArrayList<>();
    for (SessionMember each : session.members()) {
      if (!each.name().equals(arm.name())) {
        ControllerState state =
            each.name().equals(seen.name()) ? ofSeen : state(each, ofSeen, past);
        state.safety().stop().flatMap(stop -> stop.hitLinkOf(arm.name())).ifPresent(links::add);
      }
    }
    return links;
  }

  /**
   * The devices of all controllers.
   *
   * @param draft those that people change, for each controller; empty for those that there are
   * @param chosen the name of the one that people have chosen
   */
  DeviceSight devices(
      ControllerState ofSeen,
      boolean past,
      Optional<List<List<DeviceSetup>>> draft,
      Optional<String> chosen) {
    List<SessionMember> members = session.members();
    List<List<DeviceSetup>> real =
        members.stream().map(each -> each.options().equipment().devices()).toList();
    Optional<List<List<DeviceSetup>>> changed =
        draft.map(each -> ofEach(members.size(), each)).filter(each -> !each.equals(real));
    List<List<DeviceSetup>> setups = changed.orElse(real);
    SessionMember seen = seen();
    int first = members.indexOf(seen);
    List<DeviceState> states = new ArrayList<>(ofSeen.devices());
    DeviceSight sight = DeviceSight.of(setups.get(first), ofSeen.devices(), changed.isPresent());
    for (int i = 0; i < members.size(); i++) {
      if (i != first && !ofFile.getAsBoolean()) {
        List<DeviceState> now = state(members.get(i), ofSeen, past).devices();
        states.addAll(now);
        sight = sight.and(DeviceSight.of(setups.get(i), now, changed.isPresent()));
      }
    }
    Map<String, Double> travelM =
        belts.at(ofSeen.timeS(), real.stream().flatMap(List::stream).toList(), states);
    if (chosen.isPresent()) {
      sight = sight.choosing(chosen.get(), setups.stream().flatMap(List::stream).toList());
    }
    return sight.withTravel(travelM).seenFrom(Poses.inverse(seen.baseInCell()));
  }

  /** The draft may be of a cell with fewer controllers, or of one with more. */
  private static List<List<DeviceSetup>> ofEach(int controllers, List<List<DeviceSetup>> draft) {
    List<List<DeviceSetup>> each = new ArrayList<>();
    for (int i = 0; i < controllers; i++) {
      each.add(i < draft.size() ? draft.get(i) : List.of());
    }
    return each;
  }
}
