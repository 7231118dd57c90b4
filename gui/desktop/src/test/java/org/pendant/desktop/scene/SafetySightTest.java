package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.safety.StopCategory;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.desktop.scene.SafetySight.State;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

final class SafetySightTest {
  private static final SafetyConfiguration STANDARD =
      SafetyConfiguration.standard(ArmLibrary.load("ur5e"));
  private static final SafetySight.Wanted ALL = new SafetySight.Wanted(true, true, true, true);
  private static final SafetySight.Wanted NOTHING =
      new SafetySight.Wanted(false, false, false, false);
  private static final ToolDirection DOWN =
      new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), 0.5, Applies.BOTH);

  private static SafetyPlane plane(String name, double heightM, Applies applies) {
    return new SafetyPlane(name, 0, 0, heightM, new Axis(0, 0, 1), applies, false);
  }

  private static SafetyStop stop(int code, int argument, OptionalInt joint, String sentence) {
    return new SafetyStop(
        SafetyMode.PROTECTIVE_STOP,
        StopCategory.TWO,
        code,
        argument,
        joint,
        1,
        0,
        0,
        "",
        "C" + code + "A" + argument + " protective stop at 1.000 s: " + sentence);
  }

  private static SafetySight sight(
      SafetyConfiguration holds,
      Optional<SafetyConfiguration> proposed,
      Optional<SafetyStop> stop,
      boolean reduced,
      SafetySight.Wanted wanted) {
    return SafetySight.of(holds, proposed, stop, reduced, Models.WORKING, wanted);
  }

  private static List<State> states(SafetySight sight) {
    return sight.planes().stream().map(SafetySight.Plane::state).toList();
  }

  @Test
  void aPlaneOfTheOtherModeWaits() {
    SafetyConfiguration holds =
        STANDARD.withPlanes(
            plane("always", 0, Applies.BOTH),
            plane("normal", 0, Applies.NORMAL),
            plane("reduced", 0, Applies.REDUCED),
            plane("trigger", 0, Applies.TRIGGERS_REDUCED));

    assertEquals(
        List.of(State.HOLDS, State.HOLDS, State.WAITS, State.HOLDS),
        states(sight(holds, Optional.empty(), Optional.empty(), false, ALL)));
    assertEquals(
        List.of(State.HOLDS, State.WAITS, State.HOLDS, State.HOLDS),
        states(sight(holds, Optional.empty(), Optional.empty(), true, ALL)));
  }

  @Test
  void aPlaneThatHasStoppedTheArmIsSeenAlthoughPlanesAreHidden() {
    SafetyConfiguration holds =
        STANDARD.withPlanes(plane("floor", 0, Applies.BOTH), plane("wall", 0, Applies.BOTH));
    SafetyStop stop =
        stop(152, 1, OptionalInt.empty(), "tool comes too close to safety plane \"wall\"");

    SafetySight sight = sight(holds, Optional.empty(), Optional.of(stop), false, NOTHING);

    assertEquals(
        List.of(new SafetySight.Plane(holds.planes().get(1), State.TRIPPED)), sight.planes());
  }

  @Test
  void whatIsTypedIsSeenBesideWhatHolds() {
    SafetyConfiguration holds = STANDARD.withPlanes(plane("floor", 0, Applies.BOTH));
    SafetyConfiguration typed = STANDARD.withPlanes(plane("floor", 0.1, Applies.BOTH));

    SafetySight sight = sight(holds, Optional.of(typed), Optional.empty(), false, ALL);

    assertEquals(List.of(State.HOLDS, State.PROPOSED), states(sight));
    assertEquals("floor (not applied)", sight.planes().getLast().words());
  }

  @Test
  void theNameSaysWhenAPlaneHoldsAndThatTheElbowIsMeant() {
    SafetyPlane plane =
        new SafetyPlane("aisle", 0, 0, 0, new Axis(0, 1, 0), Applies.TRIGGERS_REDUCED, true);

    assertEquals(
        "aisle, triggers reduced mode, elbow too",
        new SafetySight.Plane(plane, State.HOLDS).words());
  }

  @Test
  void theToolDirectionTripsByItsStop() {
    SafetyConfiguration holds = STANDARD.withToolDirection(DOWN);
    SafetyStop stop = stop(151, 0, OptionalInt.empty(), "tool comes too close to its largest tilt");

    assertEquals(
        List.of(new SafetySight.Direction(DOWN, State.TRIPPED)),
        sight(holds, Optional.empty(), Optional.of(stop), false, ALL).directions());
    assertEquals(
        List.of(new SafetySight.Direction(DOWN, State.HOLDS)),
        sight(holds, Optional.empty(), Optional.empty(), false, ALL).directions());
    assertEquals(
        List.of(), sight(holds, Optional.empty(), Optional.empty(), false, NOTHING).directions());
  }

  @Test
  void theJointNearestToItsLimitShowsItsRange() {
    SafetyLimits normal = STANDARD.normal();
    SafetyConfiguration holds =
        STANDARD.withLimits(range(normal, 3, -1.8, 0), range(STANDARD.reduced(), 3, -1.8, 0));

    SafetySight sight = sight(holds, Optional.empty(), Optional.empty(), false, ALL);

    assertEquals(List.of(new SafetySight.Range(3, -1.8, 0, State.HOLDS)), sight.joints());
  }

  @Test
  void aRangeThatIsTypedIsSeen() {
    SafetyConfiguration typed =
        STANDARD.withLimits(
            range(STANDARD.normal(), 2, -2, 2), range(STANDARD.reduced(), 2, -2, 2));

    SafetySight sight = sight(STANDARD, Optional.of(typed), Optional.empty(), false, NOTHING);

    assertTrue(sight.joints().contains(new SafetySight.Range(2, -2, 2, State.PROPOSED)));
  }

  @Test
  void whatIsTypedOrHasStoppedTheArmIsNamedBeforeThePlacesOfAProgram() {
    assertEquals(
        List.of(State.PROPOSED, State.TRIPPED),
        Stream.of(State.values()).filter(State::named).toList());
  }

  @Test
  void aRangeThatIsTypedForBothModesIsSeenOnceInThePlaceOfTheOneThatHolds() {
    SafetyConfiguration holds =
        STANDARD.withLimits(
            range(STANDARD.normal(), 2, -3, 3), range(STANDARD.reduced(), 2, -3, 3));
    SafetyConfiguration typed =
        STANDARD.withLimits(
            range(STANDARD.normal(), 2, -2, 2), range(STANDARD.reduced(), 2, -2, 2));

    SafetySight sight = sight(holds, Optional.of(typed), Optional.empty(), false, ALL);

    assertEquals(List.of(new SafetySight.Range(2, -2, 2, State.PROPOSED)), sight.joints());
  }

  @Test
  void aJointThatWasStoppedAtItsLimitIsSeen() {
    SafetyStop stop =
        stop(150, 4, OptionalInt.of(4), "wrist 2 (joint 4) comes too close to its position limit");

    SafetySight sight = sight(STANDARD, Optional.empty(), Optional.of(stop), false, NOTHING);

    assertEquals(List.of(4), sight.joints().stream().map(SafetySight.Range::joint).toList());
    assertEquals(State.TRIPPED, sight.joints().getFirst().state());
  }

  private static SafetyLimits range(SafetyLimits l, int joint, double minRad, double maxRad) {
    Joints min = l.jointMinRad().with(joint, minRad);
    return new SafetyLimits(
        l.powerW(),
        l.momentumKgMPerS(),
        l.stoppingTimeS(),
        l.stoppingDistanceM(),
        l.toolSpeedMPerS(),
        l.toolForceN(),
        l.elbowSpeedMPerS(),
        l.elbowForceN(),
        l.jointSpeedRadPerS(),
        min,
        l.jointMaxRad().with(joint, maxRad));
  }
}
