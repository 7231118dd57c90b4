package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.Optional;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.pose.Pose;

/**
 * Freedrive presenter: freedrive by button: along which axes, held or switched on. One thread uses
 * it.
 */
final class FreedrivePresenter {
  private final RepeatedCommand hold;
  private Optional<FreedriveState> state = Optional.empty();
  private FreeAxes free = FreeAxes.ALL;
  private JogAxes axes = JogAxes.BASE;
  private Pose frameInBase = Pose.ZERO;
  private boolean movable;

  /** Switched off. */
  FreedrivePresenter(RepeatedCommand hold) {
    this.hold = hold;
  }

  /** Takes the newest snapshot, and repeats what is held; about 30 times a second. */
  void take(ControllerState newest, boolean mayMove) {
    state = Optional.of(newest.freedrive());
    movable = mayMove;
    if (!mayMove || hold.refused()) {
      release();
    } else {
      hold.repeat();
    }
  }

  /** Whether freedrive can be switched on. */
  boolean movable() {
    return movable;
  }

  /** The button is pressed, or freedrive is switched on. */
  void begin() {
    if (movable && !hold.held()) {
      hold.begin(command());
    }
  }

  private Command command() {
    FreedriveFrame frame =
        switch (axes) {
          case BASE -> FreedriveFrame.BASE;
          case TOOL -> FreedriveFrame.TOOL;
          case FRAME -> new FreedriveFrame.Feature(frameInBase);
        };
    return new ManualCommand.StartFreedrive(free, frame);
  }

  /** The button is let go, or freedrive is switched off. */
  void release() {
    hold.release();
  }

  /** Whether it is held or switched on here. */
  boolean on() {
    return hold.held() && !hold.refused();
  }

  FreeAxes free() {
    return free;
  }

  /** Frees or locks an axis, 0 to 5; at once if the arm is guided. */
  void setFree(int axis, boolean wanted) {
    setFree(free.with(axis, wanted));
  }

  /** Frees these axes and locks the others. */
  void setFree(FreeAxes wanted) {
    free = wanted;
    hold.change(command());
  }

  JogAxes axes() {
    return axes;
  }

  /** Whose axes these are from now on. */
  void setAxes(JogAxes wanted) {
    axes = wanted;
    hold.change(command());
  }

  /** What {@link JogAxes#FRAME} is from now on. */
  void setFrame(Pose inBase) {
    if (!inBase.equals(frameInBase)) {
      frameInBase = inBase;
      hold.change(command());
    }
  }

  /** Why the arm cannot be guided, or no longer; empty if it can. */
  String reason() {
    return JointNames.sentence(hold.reason());
  }

  /** What is to be said of a singularity; empty if none is near. */
  String warning() {
    return state
        .map(
            now ->
                switch (now.distance()) {
                  case NORMAL -> "";
                  case NEAR -> text("nearASingularityLockedAxesBegin");
                  case TOO_CLOSE -> text("tooCloseToASingularityWith");
                })
        .orElse("");
  }

  /** Whether freedrive is on, and who has switched it on. */
  String status() {
    return state
        .flatMap(FreedriveState::mode)
        .map(
            mode ->
                switch (mode.holder()) {
                  case PROGRAM -> text("theProgramHasSwitchedFreedriveOn");
                  case HAND -> text("freedriveIsOn");
                  case INPUT -> text("anInputHasSwitchedFreedriveOn");
                })
        .orElse(text("freedriveIsOff"));
  }
}
