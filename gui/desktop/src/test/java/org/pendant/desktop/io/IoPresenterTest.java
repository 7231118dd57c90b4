package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.safety.SafetyInput;

final class IoPresenterTest {
  private static final Signal INPUT = new Signal(SignalBank.STANDARD_IN, 2);

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final List<String> told = new ArrayList<>();
  private final PulseTimer pulses = new PulseTimer(controller::submit);
  private final IoPresenter presenter =
      new IoPresenter(controller::submit, pulses, Runnable::run, told::add);

  @BeforeEach
  void seeFirstFrame() {
    frame();
  }

  private void frame() {
    controller.advance();
    pulses.frame(controller.state());
    presenter.take(controller.state());
  }

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      frame();
    }
  }

  private boolean high() {
    return (controller.state().io().bits(SignalBank.STANDARD_IN) >> 2 & 1) != 0;
  }

  @Test
  void anInputIsForcedAndLetGoAgain() {
    presenter.toggle(INPUT);
    assertTrue(presenter.level(INPUT), "what was asked for shows at once");
    frame();
    assertTrue(high());
    presenter.toggle(INPUT);
    frame();
    assertFalse(high());
    assertFalse(presenter.level(INPUT));
  }

  @Test
  void aPulseLastsItsLengthOfRobotTime() {
    presenter.setPulseLength(new PulseLength(0.1));
    presenter.pulse(INPUT);
    frame();
    assertTrue(presenter.pulsing(INPUT));
    frames(50);
    assertTrue(high(), "0.1 s are 50 frames");
    frames(2);
    assertFalse(high());
    assertFalse(presenter.pulsing(INPUT));
  }

  @Test
  void aPulseOnAHighInputIsLow() {
    presenter.toggle(INPUT);
    frame();
    presenter.setPulseLength(new PulseLength(0.01));
    presenter.pulse(INPUT);
    frame();
    assertFalse(high());
    frames(8);
    assertTrue(high());
  }

  @Test
  void whoSetsAnInputEndsItsPulse() {
    presenter.setPulseLength(new PulseLength(0.02));
    presenter.pulse(INPUT);
    frame();
    presenter.toggle(INPUT);
    presenter.toggle(INPUT);
    frames(50);
    assertTrue(high());
  }

  @Test
  void aSafetyInputIsDemandedAndLetGo() {
    presenter.toggle(SafetyInput.REDUCED_MODE);
    frames(2);
    assertTrue(presenter.active(SafetyInput.REDUCED_MODE));
    assertTrue(controller.state().safety().reduced());
    presenter.toggle(SafetyInput.REDUCED_MODE);
    frames(2);
    assertFalse(presenter.active(SafetyInput.REDUCED_MODE));
    assertEquals(List.of(), told);
  }
}
