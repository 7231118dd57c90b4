package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.controller.freedrive.FreedriveStart;
import org.pendant.controller.jog.Jogging;
import org.pendant.models.time.FrameTime;
import org.pendant.script.value.Value;

/**
 * Freedrive session of an operator: lasts as long as a screen renews it or an input is high. A
 * session that ended early stays ended until its button is released and pressed again.
 */
final class FreedriveSession {
  private static final long DEAD_MAN_FRAMES = FrameTime.framesFor(Jogging.DEAD_MAN_S);

  private final ControlBox box;
  private Optional<Hold> hold = Optional.empty();
  private boolean inputDemands;

  /** What the operator at a screen holds, and why it has ended, if it has. */
  private static final class Hold {
    final FreedriveMode mode;
    long lastFrame;
    Optional<Refusal> reason;

    Hold(FreedriveMode mode, Optional<Refusal> reason) {
      this.mode = mode;
      this.reason = reason;
    }
  }

  FreedriveSession(ControlBox box) {
    this.box = box;
  }

  /** Begins, or continues; answers why the arm cannot be guided, or no longer. */
  Optional<Refusal> hold(FreeAxes axes, FreedriveFrame frame) {
    FreedriveMode mode = new FreedriveMode(FreedriveHolder.HAND, axes, frame, true);
    if (hold.isEmpty() || !hold.get().mode.equals(mode)) {
      box.motion().clearFault();
      hold = Optional.of(new Hold(mode, refusal(box.modes().freedrive().start(mode))));
    }
    hold.get().lastFrame = box.clock().frame() + DEAD_MAN_FRAMES;
    noticeEnd(hold.get());
    return hold.get().reason;
  }

  private static Optional<Refusal> refusal(FreedriveStart start) {
    return switch (start) {
      case FreedriveStart.Started _ -> Optional.empty();
      case FreedriveStart.Refused refused -> Optional.of(refused.refusal());
      case FreedriveStart.WrongPayload wrong ->
          Optional.of(
              new Refusal(
                  Refusal.Code.INVALID,
                  text("payloadWrong", number(wrong.errorN()), number(wrong.toleranceN()))));
    };
  }

  private static String number(double newtons) {
    return Value.of(Math.round(10 * newtons) / 10.0).text();
  }

  /** Let go: the arm holds where it is. */
  void release() {
    hold = Optional.empty();
    box.modes().freedrive().end(FreedriveHolder.HAND);
  }

  /** Looks at how it goes; once a frame. */
  void step() {
    if (hold.isPresent()) {
      watch(hold.get());
    }
  }

  private void watch(Hold present) {
    if (box.clock().frame() > present.lastFrame) {
      release();
    } else {
      noticeEnd(present);
    }
  }

  private void noticeEnd(Hold present) {
    boolean guided = box.modes().freedrive().heldBy(FreedriveHolder.HAND);
    if (!guided && present.reason.isEmpty()) {
      present.reason =
          Optional.of(
              box.safety()
                  .programRefusal()
                  .orElse(new Refusal(Refusal.Code.ARM_POWER, text("freedriveEnded"))));
    }
  }

  /**
   * The level of the inputs with the freedrive action; once a frame.
   *
   * @param demanded whether one of them is high
   * @param program why a program keeps the arm from being guided; asked only when that matters
   */
  void followInput(boolean demanded, Supplier<Optional<Refusal>> program) {
    if (demanded == inputDemands) {
      return;
    }
    inputDemands = demanded;
    if (!demanded) {
      box.modes().freedrive().end(FreedriveHolder.INPUT);
      return;
    }
    Optional<Refusal> refusal = program.get();
    if (refusal.isEmpty() && !box.modes().freedrive().active()) {
      refusal =
          refusal(box.modes().freedrive().start(FreedriveMode.free(FreedriveHolder.INPUT, true)));
    }
    refusal.ifPresent(why -> box.log().warning(text("freedriveByInput", why.text())));
  }
}
