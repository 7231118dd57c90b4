package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.WorldCommand;
import org.pendant.models.dynamics.Payload;

/** What programs notice of the payload that they declare and of the load that truly hangs there. */
final class PayloadProgramTest {
  private static final double GRAVITY = 9.82;
  private static final double SHARE = 0.01;
  private static final int SETTLE_FRAMES = 1000;

  private final RunningProgram running = new RunningProgram();

  /** Hangs a load on the flange and waits until the arm has come to rest again. */
  private void attach(double massKg) {
    running.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(massKg, 0.02, -0.01, 0.08))));
    running.advance(SETTLE_FRAMES);
  }

  /** Compares each number that the program said with one expected, within one in a hundred. */
  private void said(double... expected) {
    List<Double> numbers = running.numbers();
    assertEquals(expected.length, numbers.size(), numbers::toString);
    for (int i = 0; i < expected.length; i++) {
      double room = Math.max(0.1, SHARE * Math.abs(expected[i]));
      assertEquals(expected[i], numbers.get(i), room, numbers::toString);
    }
  }

  @Test
  void aMassThatNobodyDeclaredIsAForceInEveryPosture() {
    attach(1);
    running.run(
        """
        wrench = get_tcp_force()
        textmsg(wrench[2])
        movej([1, -1, -1, -1, 1, 1])
        sleep(1)
        wrench = get_tcp_force()
        textmsg(wrench[2])
        textmsg(force())
        """);
    said(-GRAVITY, -GRAVITY, GRAVITY);
  }

  @Test
  void theErrorOfADeclaredMassIsTheForceThatIsLeftOnceTheToolTurns() {
    attach(3);
    // the payload's declaration zeroes the sensor with 1 kg too much; upside down that is 2 kg
    running.run(
        """
        set_target_payload(2, [0.02, -0.01, 0.08])
        textmsg(force())
        q = get_target_joint_positions()
        movej([q[0], q[1], q[2], q[3] + 3.141593, q[4], q[5]])
        sleep(1)
        wrench = get_tcp_force()
        textmsg(wrench[2])
        """);
    said(0, -2 * GRAVITY);
  }

  @Test
  void withTheRightPayloadAMovingArmFeelsNothing() {
    attach(3);
    running.run(
        """
        set_target_payload(3, [0.02, -0.01, 0.08])
        global largest = 0
        thread watcher():
          while True:
            if force() > largest:
              largest = force()
            end
            sync()
          end
        end
        run watcher()
        movej([1, -1, -1, -1, 1, 1])
        textmsg(largest)
        """);
    said(0);
  }

  @Test
  void zeroingMakesWhatIsFeltNowTheZero() {
    attach(2);
    running.run(
        """
        textmsg(force())
        zero_ftsensor()
        textmsg(force())
        """);
    said(2 * GRAVITY, 0);
  }

  @Test
  void aTransitionChangesTheReadingEvenlyAndZeroesAtItsEnd() {
    attach(2);
    running.run(
        """
        set_target_payload(1, [0.02, -0.01, 0.08], transition_time=0.5)
        textmsg(force())
        sleep(0.25)
        textmsg(force())
        sleep(0.22)
        textmsg(force())
        sleep(0.05)
        textmsg(force())
        """);
    List<Double> forces = running.numbers();
    assertEquals(2 * GRAVITY, forces.get(0), 0.1, forces::toString);
    assertEquals(1.5 * GRAVITY, forces.get(1), 0.1, forces::toString);
    assertEquals(1.06 * GRAVITY, forces.get(2), 0.1, forces::toString);
    assertEquals(0, forces.get(3), 0.01, forces::toString);
  }

  @Test
  void anUnknownLoadIsEstimatedFromFourPoses() {
    attach(2.5);
    running.run(
        """
        poses = make_list(0, get_actual_tcp_pose(), 4)
        wrenches = make_list(0, get_tcp_force(), 4)
        tilts = [-1.6, -1.1, -0.6, -0.1]
        i = 0
        while i < 4:
          movej([0, -1.57, -1.57, tilts[i], 1.57 + tilts[i] / 2, tilts[i]])
          sleep(1)
          poses.append(get_actual_tcp_pose())
          wrenches.append(get_tcp_force())
          i = i + 1
        end
        payload = estimate_payload(poses, wrenches)
        textmsg(payload.mass)
        cog = payload.cog
        textmsg(cog[0])
        textmsg(cog[1])
        textmsg(cog[2])
        set_target_payload(payload.mass, payload.cog)
        movej([1, -1, -1, -1, 1, 1])
        sleep(1)
        textmsg(force())
        """);
    List<Double> found = running.numbers();
    assertEquals(2.5, found.get(0), 2.5 * SHARE, found::toString);
    assertEquals(0.02, found.get(1), 1e-3, found::toString);
    assertEquals(-0.01, found.get(2), 1e-3, found::toString);
    assertEquals(0.08, found.get(3), 1e-3, found::toString);
    assertEquals(0, found.get(4), 0.3, found::toString);
  }

  @Test
  void withoutAKnownLoadThePayloadIsWhatTheProgramSays() {
    running.run(
        """
        set_target_payload(3, [0, 0, 0.1])
        movej([1, -1, -1, -1, 1, 1])
        sleep(1)
        textmsg(force())
        """);
    said(0);
    assertTrue(running.reported().isEmpty(), () -> running.reported().toString());
  }
}
