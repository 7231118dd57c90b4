package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.models.pose.Pose;

/** Freedrive by button, with a controller but without a window. */
final class FreedrivePresenterTest {
  private final FreedriveFixture fixture = new FreedriveFixture();
  private final FreedrivePresenter presenter =
      new FreedrivePresenter(
          new RepeatedCommand(fixture::submit, Runnable::run, new ManualCommand.EndFreedrive()));

  private void refresh(int times) {
    for (int i = 0; i < times; i++) {
      presenter.take(fixture.state(), true);
      fixture.frames(FreedriveFixture.FRAMES_A_REFRESH);
    }
    presenter.take(fixture.state(), true);
  }

  private boolean guided() {
    return fixture.state().freedrive().active();
  }

  @Test
  void itIsOnUntilTheButtonIsLetGo() {
    refresh(1);
    assertEquals("Freedrive is off.", presenter.status());
    presenter.begin();
    refresh(30);
    assertTrue(guided());
    assertTrue(presenter.on());
    assertEquals("Freedrive is on.", presenter.status());
    presenter.release();
    refresh(1);
    assertFalse(guided());
    assertFalse(presenter.on());
  }

  @Test
  void aScreenThatIsNoLongerRefreshedEndsIt() {
    refresh(1);
    presenter.begin();
    refresh(5);
    fixture.frames(200);
    assertFalse(guided());
  }

  @Test
  void whatCannotMoveCannotBeGuided() {
    presenter.take(fixture.state(), false);
    presenter.begin();
    assertEquals(0, fixture.sent.size());
    refresh(1);
    presenter.begin();
    refresh(5);
    presenter.take(fixture.state(), false);
    fixture.frames(2);
    assertFalse(guided());
  }

  @Test
  void axesChangeWhileItIsOn() {
    refresh(1);
    presenter.begin();
    refresh(2);
    presenter.setFree(2, false);
    presenter.setAxes(JogAxes.FRAME);
    Pose frame = new Pose(0.1, 0, 0, 0, 0, 1);
    presenter.setFrame(frame);
    refresh(2);
    var mode = fixture.state().freedrive().mode().orElseThrow();
    assertEquals(FreeAxes.ALL.with(2, false), mode.axes());
    assertEquals(new FreedriveFrame.Feature(frame), mode.frame());
  }

  @Test
  void aStopEndsItAndTheReasonStaysToBeRead() {
    refresh(1);
    presenter.begin();
    refresh(2);
    fixture.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    refresh(3);
    assertFalse(presenter.on());
    assertTrue(presenter.reason().contains("safeguard"), presenter.reason());
    fixture.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    refresh(3);
    assertFalse(guided(), "nobody has switched it on again");
    presenter.begin();
    refresh(2);
    assertTrue(guided());
    assertEquals("", presenter.reason());
  }

  @Test
  void theProgramsFreedriveIsToldOf() {
    fixture.run("freedrive_mode()");
    refresh(1);
    assertEquals("The program has switched freedrive on.", presenter.status());
  }

  @Test
  void aSingularityIsToldOf() {
    fixture.run("movej([0, -1.57, -1.57, -1.57, 0.01, 0], a=20, v=3)");
    fixture.frames(1500);
    refresh(1);
    assertEquals(
        "Too close to a singularity: with locked axes the arm is hard to move.",
        presenter.warning());
  }
}
