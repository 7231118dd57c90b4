package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;

final class PayloadBallTest {
  private static final Pose FLANGE = new Pose(0.5, 0.1, 0.4, Math.PI, 0, 0);

  @Test
  void isAroundTheCentreOfGravity() {
    Ball ball = PayloadBall.of(Payload.of(2, 0.01, 0.02, 0.05), FLANGE).orElseThrow();

    assertEquals(0.51, ball.centreM().x(), 1e-9);
    assertEquals(0.08, ball.centreM().y(), 1e-9);
    assertEquals(0.35, ball.centreM().z(), 1e-9);
  }

  @Test
  void eightTimesTheMassIsTwiceAsWide() {
    double light = PayloadBall.of(Payload.of(1, 0, 0, 0), FLANGE).orElseThrow().radiusM();
    double heavy = PayloadBall.of(Payload.of(8, 0, 0, 0), FLANGE).orElseThrow().radiusM();

    assertEquals(2 * light, heavy, 1e-12);
  }

  @Test
  void nothingIsNoBall() {
    assertTrue(PayloadBall.of(Payload.NONE, FLANGE).isEmpty());
  }
}
