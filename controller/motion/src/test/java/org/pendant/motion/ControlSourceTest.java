package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/** The target of an arm that is guided by hand. */
class ControlSourceTest {
  private static final Joints START =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Joints ELSEWHERE = START.with(0, 0.3);
  private static final Joints TURNING = Joints.ZERO.with(0, 0.8);

  private final MotionControl control = new MotionControl(ArmLibrary.load("ur5e"), START);

  /** Carries the tool aside by a constant way. */
  private static final class Aside implements PathOffset {
    private boolean active = true;

    @Override
    public boolean active() {
      return active;
    }

    @Override
    public void apply(double[] tcpInBase) {
      tcpInBase[10] += 0.001;
    }

    @Override
    public void end() {
      active = false;
    }
  }

  private static MotionPlan stop() {
    return (from, speed) -> new StopJ(from, speed, 1);
  }

  @Test
  void followsTheArm() throws PlanningException {
    control.startGuidance();
    assertTrue(control.guided());
    control.step();
    control.guide(ELSEWHERE, TURNING);
    assertEquals(ELSEWHERE, control.positionRad());
    control.step();
    assertEquals(TURNING, control.speedRadPerS());
    assertFalse(control.steady());
  }

  @Test
  void comesToRestFromWhatTheArmDoes() throws PlanningException {
    control.startGuidance();
    control.guide(ELSEWHERE, TURNING);
    control.endGuidance();
    Joints last = ELSEWHERE;
    for (int frame = 0; frame < 49; frame++) {
      control.step();
      assertTrue(control.positionRad().q0() > last.q0());
      assertTrue(control.positionRad().q0() - last.q0() < 0.8 * FrameTime.FRAME_S + 1e-9);
      last = control.positionRad();
    }
    control.step();
    control.step();
    assertEquals(Joints.ZERO, control.speedRadPerS());
    assertEquals(0.3 + 0.8 * 0.8 / 2 / 8, control.positionRad().q0(), 1e-9);
    assertFalse(control.moving());
  }

  @Test
  void staysWhereAnArmAtRestHasBeenLeft() throws PlanningException {
    control.startGuidance();
    control.guide(ELSEWHERE, Joints.ZERO);
    control.endGuidance();
    control.step();
    assertEquals(ELSEWHERE, control.positionRad());
    assertFalse(control.moving());
  }

  @Test
  void nothingElseMovesItMeanwhile() throws PlanningException {
    control.startGuidance();
    assertRefused(() -> control.start(stop()));
    assertRefused(() -> control.takeOver(stop()));
    assertRefused(() -> control.jumpTo(ELSEWHERE));
    control.endGuidance();
    control.jumpTo(ELSEWHERE);
    assertEquals(ELSEWHERE, control.positionRad());
  }

  private static void assertRefused(Executable call) {
    PlanningException error = assertThrows(PlanningException.class, call);
    assertEquals("the arm is in freedrive, which must be ended first", error.getMessage());
  }

  @Test
  void aMotionThatSomebodyWaitsForIsNotTakenAway() throws PlanningException {
    control.start((from, speed) -> new StopJ(from, TURNING, 1));
    PlanningException error = assertThrows(PlanningException.class, control::startGuidance);
    assertEquals("robot-in-use", error.code());
    assertFalse(control.guided());
  }

  @Test
  void whatCarriedTheToolAsideIsGivenUpWithoutAJump() throws PlanningException {
    Aside aside = new Aside();
    control.addOffset(aside);
    control.step();
    Joints carried = control.positionRad();
    assertTrue(carried.maxAbsDifference(START) > 1e-4);
    control.startGuidance();
    assertEquals(carried, control.positionRad());
    assertFalse(aside.active());
    control.guide(ELSEWHERE, Joints.ZERO);
    assertEquals(ELSEWHERE, control.positionRad());
  }

  @Test
  void anArmWithoutPowerIsNotGuided() throws PlanningException {
    control.startGuidance();
    control.adopt(ELSEWHERE);
    assertFalse(control.guided());
    control.endGuidance();
    control.step();
    assertEquals(ELSEWHERE, control.positionRad());
  }
}
