package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;

/** Dragging the arm, with a controller but without a window. */
@Tag("slow")
final class ArmPullTest {
  private static final Vector3 ORIGIN = new Vector3(0, 0, 0);

  private final FreedriveFixture fixture = new FreedriveFixture();
  private final ArmPull pull = new ArmPull(fixture::submit, Runnable::run);

  private void refresh(int times) {
    for (int i = 0; i < times; i++) {
      pull.take(fixture.state(), Pace.REAL_TIME);
      fixture.frames(FreedriveFixture.FRAMES_A_REFRESH);
    }
    pull.take(fixture.state(), Pace.REAL_TIME);
  }

  private Pose tcp() {
    return fixture.state().arm().actualTcpInBase();
  }

  private static Vector3 beside(Pose tcp, double y) {
    return new Vector3(tcp.x(), tcp.y() + y, tcp.z());
  }

  @Test
  void theArmFollowsThePointerAndStaysWhereItIsLeft() {
    refresh(1);
    Pose start = tcp();
    pull.begin(5, ORIGIN, beside(start, 0));
    refresh(3);
    assertEquals(start.y(), tcp().y(), 1e-3, "nothing moves before the pointer does");
    for (int i = 1; i <= 20; i++) {
      pull.move(beside(start, 0.01 * i));
      refresh(1);
    }
    refresh(60);
    assertEquals(start.y() + 0.2, tcp().y(), 0.01);
    pull.end();
    refresh(10);
    assertFalse(fixture.state().freedrive().active());
    Joints rests = fixture.state().arm().actualPositionRad();
    refresh(20);
    assertTrue(fixture.state().arm().actualPositionRad().maxAbsDifference(rests) < 1e-4);
    assertEquals(Optional.empty(), pull.newReason());
  }

  @Test
  void anyLinkCanBePulled() {
    refresh(1);
    Joints start = fixture.state().arm().actualPositionRad();
    pull.begin(1, new Vector3(0.2, 0, 0), new Vector3(0.4, 0, 0.5));
    refresh(40);
    Joints now = fixture.state().arm().actualPositionRad();
    assertTrue(now.maxAbsDifference(start) > 0.05, () -> pull.newReason() + " at " + now);
    assertEquals(start.q5(), now.q5(), 0.1, "joints behind it hardly turn");
  }

  @Test
  void freedriveThatIsOnAlreadyIsUsedAsItIs() {
    fixture.run("freedrive_mode([0, 1, 0, 0, 0, 0])");
    refresh(1);
    assertTrue(pull.grabs(false));
    Pose start = tcp();
    pull.begin(5, ORIGIN, new Vector3(start.x() + 0.3, start.y() + 0.2, start.z()));
    refresh(40);
    assertEquals(start.x(), tcp().x(), 1e-3);
    assertTrue(tcp().y() > start.y() + 0.05, "at " + tcp());
    pull.end();
    refresh(10);
    assertTrue(fixture.state().freedrive().active(), "it is the program's");
    assertTrue(
        fixture.sent.stream().noneMatch(each -> each instanceof ManualCommand.StartFreedrive));
  }

  @Test
  void aProgramThatWantsTheArmForItselfIsNotDisturbed() {
    fixture.run("textmsg(1)");
    refresh(1);
    pull.begin(5, ORIGIN, beside(tcp(), 0.2));
    assertEquals(
        Optional.of("Program p is running. Stop it to move the arm by hand."), pull.newReason());
    assertEquals(Optional.empty(), pull.newReason(), "told once");
    assertFalse(pull.pulls());
    refresh(2);
    assertTrue(fixture.sent.isEmpty(), fixture.sent::toString);
  }

  @Test
  void aRefusalIsToldAndEndsTheDrag() {
    fixture.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(2, 0, 0, 0.05))));
    fixture.frames(1000);
    refresh(1);
    pull.begin(5, ORIGIN, beside(tcp(), 0.2));
    refresh(3);
    String reason = pull.newReason().orElseThrow();
    assertTrue(reason.startsWith("The declared payload is wrong by 19.6 N"), reason);
    assertEquals(1, starts());
  }

  private long starts() {
    return fixture.sent.stream()
        .filter(each -> each instanceof ManualCommand.StartFreedrive)
        .count();
  }

  @Test
  void aStopEndsTheDrag() {
    refresh(1);
    pull.begin(5, ORIGIN, beside(tcp(), 0.2));
    refresh(5);
    fixture.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    refresh(5);
    assertTrue(pull.newReason().orElseThrow().contains("safeguard"));
    refresh(15);
    Joints rests = fixture.state().arm().actualPositionRad();
    refresh(20);
    assertTrue(fixture.state().arm().actualPositionRad().maxAbsDifference(rests) < 1e-3);
  }

  @Test
  void aScreenThatIsNoLongerRefreshedPullsNothing() {
    refresh(1);
    pull.begin(5, ORIGIN, beside(tcp(), 0.3));
    refresh(5);
    fixture.frames(500);
    assertFalse(fixture.state().freedrive().active());
    Joints speed = fixture.state().arm().actualSpeedRadPerS();
    assertTrue(speed.maxAbsDifference(Joints.ZERO) < 1e-9, "turns at " + speed);
  }

  @Test
  void dragsTurnTheViewUnlessFreedriveOrTheKeyIsOn() {
    refresh(1);
    assertFalse(pull.grabs(false));
    assertTrue(pull.grabs(true));
    pull.setWanted(true);
    assertTrue(pull.grabs(false));
  }
}
