package org.pendant.desktop.shell.start;

import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.settings.Settings;
import org.pendant.script.vm.ProgramState;

/**
 * Start choice: what is asked when a program shall start and the arm is not where it moves first:
 * whether it moves there by itself, or while the operator holds a button, or the program starts all
 * the same. It has no Swing; one thread uses it, the dispatch thread.
 */
public final class StartChoice {
  private static final String SETTING = "program.ask-start";

  private final StartArm arm;
  private final Settings settings;
  private Optional<StartPlace> place = Optional.empty();
  private Runnable start = () -> {};
  private Phase phase = Phase.NOTHING;
  private String remark = "";
  private long asked;
  private double distanceM;

  /** How far it has come. */
  public enum Phase {
    /** Nothing is asked. */
    NOTHING,
    /** The arm is somewhere else, and people choose. */
    ASKING,
    /** The arm goes there by itself. */
    MOVING,
    /** The arm has been brought there; the program waits. */
    THERE
  }

  /** Nothing is asked yet. */
  public StartChoice(StartArm arm, Settings settings) {
    this.arm = arm;
    this.settings = settings;
  }

  /** Whether it is asked at all. */
  public boolean asks() {
    return settings.get(SETTING).map(Boolean::parseBoolean).orElse(true);
  }

  /** Asks from now on, or starts programs wherever the arm is. */
  public void setAsks(boolean wanted) {
    settings.put(SETTING, String.valueOf(wanted));
  }

  /**
   * A program shall start: it does, or people are asked first. What was asked before is cancelled.
   *
   * @param first where it goes first; empty if that is not known
   */
  public void begin(Optional<StartPlace> first, ControllerState state, Runnable start) {
    cancel();
    if (!asks() || first.filter(each -> !each.reached(state)).isEmpty()) {
      start.run();
      return;
    }
    place = first;
    this.start = start;
    distanceM = first.get().distanceM(state);
    remark = "";
    phase = Phase.ASKING;
    asked++;
  }

  /** Shows where the arm is now. */
  public void refresh(ControllerState state) {
    boolean stopped = state.program().state() == ProgramState.STOPPED;
    switch (phase) {
      case NOTHING, MOVING -> {}
      case ASKING, THERE -> {
        if (!stopped) {
          // Another client has started a program.
          close();
          return;
        }
        phase = place.orElseThrow().reached(state) ? Phase.THERE : Phase.ASKING;
        distanceM = place.orElseThrow().distanceM(state);
        if (!arm.heldBecause().isEmpty() && phase == Phase.ASKING) {
          remark = StartTexts.text("theArmHasStopped", arm.heldBecause());
        }
      }
    }
  }

  /** The arm shall go there by itself; the program starts when it is there. */
  public void moveThere() {
    if (phase != Phase.ASKING || !canMove()) {
      return;
    }
    phase = Phase.MOVING;
    remark = "";
    long number = asked;
    arm.go(
        place.orElseThrow().jointsRad().orElseThrow(),
        why -> {
          if (phase == Phase.MOVING && number == asked) {
            arrived(why);
          }
        });
  }

  private void arrived(String why) {
    if (why.isEmpty()) {
      startNow();
    } else {
      phase = Phase.ASKING;
      remark = why;
    }
  }

  /** The arm shall go there as long as the user holds. */
  public void hold() {
    if (phase == Phase.ASKING && canMove()) {
      remark = "";
      arm.hold(place.orElseThrow().jointsRad().orElseThrow());
    }
  }

  /** The button is not held any more. */
  public void release() {
    arm.release();
  }

  /** The program starts, wherever the arm is. */
  public void startNow() {
    Runnable wanted = start;
    close();
    wanted.run();
  }

  /** The program does not start, and an arm on its way there stops. */
  public void cancel() {
    if (phase == Phase.MOVING) {
      arm.stop();
    }
    close();
  }

  private void close() {
    arm.release();
    phase = Phase.NOTHING;
    place = Optional.empty();
    start = () -> {};
    remark = "";
  }

  /** How far it has come. */
  public Phase phase() {
    return phase;
  }

  /** Counts what was asked, so that something new can be told from the last. */
  public long asked() {
    return asked;
  }

  /** Whether the arm can get there. */
  public boolean canMove() {
    return place.flatMap(StartPlace::jointsRad).isPresent();
  }

  /** What is the matter, in a few words. */
  public String title() {
    String name = place.map(StartPlace::name).orElse("");
    return switch (phase) {
      case NOTHING -> "";
      case ASKING -> StartTexts.text("theArmIsNotAt", name);
      case MOVING -> StartTexts.text("theArmMovesTo", name);
      case THERE -> StartTexts.text("theArmIsAt", name);
    };
  }

  /** What people should know. */
  public String text() {
    return switch (phase) {
      case NOTHING -> "";
      case ASKING ->
          !remark.isEmpty()
              ? remark
              : place.map(StartPlace::problem).filter(each -> !each.isEmpty()).isPresent()
                  ? place.orElseThrow().problem()
                  : StartTexts.text("theProgramGoesThereFirstThe", distance());
      case MOVING -> StartTexts.text("theProgramStartsWhenItIs");
      case THERE -> StartTexts.text("theProgramCanStart");
    };
  }

  private String distance() {
    return distanceM < 0.001
        ? StartTexts.text("lessThan1Mm")
        : String.format(Locale.ROOT, "%.0f mm", 1000 * distanceM);
  }
}
