package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;

import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ControlBox;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MoveJ;
import org.pendant.motion.MoveLimits;

class RevolutionCounterTest {
  private static final double TURN = 2 * Math.PI;

  /** The last joint of this arm turns without end. */
  private final CallFixture endless = new CallFixture("ur3e");

  private static Joints turned(double wrist3Rad) {
    return new Joints(-6, -1.5, -1.5, -1.5, 6, wrist3Rad);
  }

  private static void at(Joints expected, CallFixture fixture) {
    assertEquals(0, expected.maxAbsDifference(fixture.box().motion().positionRad()), 1e-12);
    assertEquals(0, expected.maxAbsDifference(fixture.box().drive().actualPositionRad()), 1e-12);
  }

  @Test
  void theEndlessJointIsCountedFromTheTurnNearestToZero() throws Exception {
    endless.box().drive().jumpTo(turned(5 * TURN + 1));
    endless.call("reset_revolution_counter");
    at(turned(1), endless);
    endless.box().drive().jumpTo(turned(-3 * TURN - 2));
    endless.call("reset_revolution_counter");
    at(turned(-2), endless);
  }

  @Test
  void aGivenPositionSaysWhichTurn() throws Exception {
    endless.box().drive().jumpTo(turned(5 * TURN + 1));
    endless.call("reset_revolution_counter", floats(0, 0, 0, 0, 0, 3 * TURN));
    at(turned(3 * TURN + 1), endless);
  }

  @Test
  void jointsWithLimitsStayAsTheyAre() throws Exception {
    CallFixture limited = new CallFixture("ur5e");
    limited.box().drive().jumpTo(turned(6));
    limited.call("reset_revolution_counter");
    at(turned(6), limited);
  }

  @Test
  void aMovingArmIsNotCountedAnew() throws Exception {
    ControlBox box = endless.box();
    box.drive().jumpTo(turned(5 * TURN));
    box.motion()
        .start(
            (from, speed) ->
                new MoveJ(
                    box.arm().description(),
                    from,
                    from.with(0, -5),
                    Pose.ZERO,
                    new MoveLimits(1, 1, 0)));
    refuses(
        "robot-in-use",
        "reset_revolution_counter: the arm is moving, must be at rest",
        () -> endless.call("reset_revolution_counter"));
  }

  @Test
  void whereToCountFromIsSixModestNumbers() {
    refuses(
        "wrong-type",
        "qNear is list [0], must be a list of 6 numbers",
        () -> endless.call("reset_revolution_counter", floats(0)));
    refuses(
        "value-out-of-range",
        "each must be -10000 to 10000 rad",
        () -> endless.call("reset_revolution_counter", floats(0, 0, 0, 0, 0, 1e6)));
  }
}
