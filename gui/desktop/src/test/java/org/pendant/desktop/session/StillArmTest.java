package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

class StillArmTest {
  private final StillArm stillArm = new StillArm();

  private static Controller resting(boolean noise) {
    Controller controller = new Controller(ControllerOptions.headless().withMeasuredNoise(noise));
    for (int i = 0; i < 10; i++) {
      controller.advance();
    }
    return controller;
  }

  @Test
  void anArmThatRestsIsShownWhereItWas() {
    Controller controller = resting(true);
    Joints first = stillArm.shown(controller.state()).arm().actualPositionRad();
    for (int i = 0; i < 500; i++) {
      controller.advance();
      ControllerState shown = stillArm.shown(controller.state());
      assertEquals(first, shown.arm().actualPositionRad());
      assertEquals(shown.arm().actualTcpInBase(), shown.geometry().actualTcpInBase());
    }
    assertNotEquals(first, controller.state().arm().actualPositionRad());
  }

  @Test
  void anArmThatIsElsewhereIsShownThere() {
    ControllerState state = resting(true).state();
    stillArm.shown(state);
    Joints there = state.arm().actualPositionRad().with(2, -1);
    assertEquals(there, stillArm.shown(state.withActualPosition(there)).arm().actualPositionRad());
  }

  @Test
  void withoutNoiseASnapshotIsShownAsItIs() {
    Controller controller = resting(false);
    stillArm.shown(controller.state());
    controller.advance();
    assertSame(controller.state(), stillArm.shown(controller.state()));
  }

  @Test
  void anArmThatTremblesAtItsTargetIsShownStillAfterAWhile() {
    ControllerState state = resting(false).state();
    Joints there = state.arm().actualPositionRad();
    Joints first = there;
    for (int i = 0; i < 200; i++) {
      Joints trembling = there.with(1, there.get(1) + 2e-5 * Math.sin(i));
      Joints shown = stillArm.shown(state.withActualPosition(trembling)).arm().actualPositionRad();
      if (i == 100) {
        first = shown;
      } else if (i > 100) {
        assertEquals(first, shown);
      }
    }
  }
}
