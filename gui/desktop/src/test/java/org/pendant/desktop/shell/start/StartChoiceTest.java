package org.pendant.desktop.shell.start;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.shell.start.StartChoice.Phase;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.FirstWaypoint;
import org.pendant.project.program.WaypointPosition;

final class StartChoiceTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final Joints PLACE = Joints.of(0.1, -1.4, -1.5, -1.6, 1.5, 0.2);
  private static final ControllerState AWAY = state(Joints.of(0.4, -1.4, -1.5, -1.6, 1.5, 0.2));
  private static final ControllerState THERE = state(PLACE);

  private final List<String> done = new ArrayList<>();
  private final FakeArm arm = new FakeArm();
  private final StartChoice choice = new StartChoice(arm, new MemorySettings());

  /** Notes what it is asked for. */
  private final class FakeArm implements StartArm {
    private Consumer<String> ended = why -> {};
    private String reason = "";

    @Override
    public void go(Joints goalRad, Consumer<String> whenEnded) {
      done.add("go");
      ended = whenEnded;
    }

    @Override
    public void stop() {
      done.add("stop");
    }

    @Override
    public void hold(Joints goalRad) {
      done.add("hold");
    }

    @Override
    public void release() {}

    @Override
    public String heldBecause() {
      return reason;
    }
  }

  private static ControllerState state(Joints joints) {
    return new Controller(ControllerOptions.headless().withArm(ArmChoice.IDEAL).withStart(joints))
        .state();
  }

  private static StartPlace place(Pose tcp, Joints joints) {
    return StartPlace.of(
            new FirstWaypoint.Target(
                "Pick", new WaypointPosition(tcp, WaypointPosition.BASE, joints, Pose.ZERO)),
            Installation.NONE,
            ARM)
        .orElseThrow();
  }

  private static StartPlace pick() {
    return place(new ForwardKinematics(ARM).flangePose(PLACE), PLACE);
  }

  private void begin(StartPlace first, ControllerState state) {
    choice.begin(Optional.of(first), state, () -> done.add("start"));
  }

  @Test
  void anArmThatIsThereStartsAtOnce() {
    begin(pick(), THERE);
    assertEquals(List.of("start"), done);
    assertEquals(Phase.NOTHING, choice.phase());
  }

  @Test
  void nothingIsAskedWhereNobodyKnowsWhereItGoesFirst() {
    choice.begin(Optional.empty(), AWAY, () -> done.add("start"));
    assertEquals(List.of("start"), done);
  }

  @Test
  void nothingIsAskedWhenPeopleDoNotWantIt() {
    choice.setAsks(false);
    begin(pick(), AWAY);
    assertEquals(List.of("start"), done);
  }

  @Test
  void anArmThatIsAwayIsAskedFor() {
    begin(pick(), AWAY);
    assertEquals(List.of(), done);
    assertEquals("The arm is not at Pick", choice.title());
    assertTrue(choice.text().contains(" mm away"), choice.text());
    choice.startNow();
    assertEquals(List.of("start"), done);
  }

  @Test
  void theProgramStartsWhenTheArmHasGoneThere() {
    begin(pick(), AWAY);
    choice.moveThere();
    assertEquals(Phase.MOVING, choice.phase());
    arm.ended.accept("");
    assertEquals(List.of("go", "start"), done);
  }

  @Test
  void aMoveThatFailsIsToldAndAskedAgain() {
    begin(pick(), AWAY);
    choice.moveThere();
    arm.ended.accept("The move was stopped");
    assertEquals(Phase.ASKING, choice.phase());
    assertEquals("The move was stopped", choice.text());
  }

  @Test
  void cancellingStopsTheArmAndStartsNothing() {
    begin(pick(), AWAY);
    choice.moveThere();
    choice.cancel();
    arm.ended.accept("");
    assertEquals(List.of("go", "stop"), done);
    assertEquals(Phase.NOTHING, choice.phase());
  }

  @Test
  void anArmThatWasBroughtThereWaitsForStart() {
    begin(pick(), AWAY);
    choice.hold();
    choice.refresh(THERE);
    assertEquals("The arm is at Pick", choice.title());
    assertEquals(List.of("hold"), done);
    choice.startNow();
    assertEquals(List.of("hold", "start"), done);
  }

  @Test
  void itSaysWhyTheArmDoesNotGoOn() {
    begin(pick(), AWAY);
    choice.hold();
    arm.reason = "there is a wall";
    choice.refresh(AWAY);
    assertEquals("The arm has stopped: there is a wall", choice.text());
  }

  @Test
  void aPlaceOutOfReachIsNotGoneTo() {
    begin(place(new Pose(3, 0, 0.5, 0, 0, 0), PLACE), AWAY);
    assertFalse(choice.canMove());
    assertTrue(choice.text().startsWith("The arm cannot reach this pose"), choice.text());
    choice.moveThere();
    choice.hold();
    assertEquals(List.of(), done);
  }

  @Test
  void aJointThatIsTurnedRoundIsAway() {
    StartPlace turned =
        place(
            new ForwardKinematics(ARM).flangePose(PLACE),
            Joints.of(0.1, -1.4, -1.5, -1.6, 1.5, 0.2 + 2 * Math.PI));
    assertFalse(turned.reached(THERE));
    assertTrue(pick().reached(THERE));
  }

  @Test
  void aFeatureThatIsNotTaughtTellsNothing() {
    assertEquals(
        Optional.empty(),
        StartPlace.of(
            new FirstWaypoint.Target(
                "Pick", new WaypointPosition(Pose.ZERO, "Table", PLACE, Pose.ZERO)),
            Installation.NONE,
            ARM));
  }
}
