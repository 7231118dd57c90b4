package org.pendant.controller.device.gripper;

import static org.pendant.controller.device.gripper.GripperTexts.text;

import java.util.function.Consumer;

/**
 * Adaptive gripper with two fingers and an 85 mm stroke: its registers and what they make of the
 * fingers, whichever line they are written by. The frame loop owns it.
 *
 * <p>Numbers are those of the registers: 0 to 255, where a position of 0 is open. The stops of the
 * fingers are at 3 and 230, as on a calibrated gripper.
 */
public final class AdaptiveGripper {
  /** The highest number of a register. */
  public static final int MAX = 255;

  /** Number of the position at which the fingers are fully open. */
  static final int OPEN = 3;

  /** Number of the position at which they are closed on nothing. */
  static final int CLOSED = 230;

  private static final double STROKE_M = 0.085;
  private static final double MIN_SPEED_M_PER_S = 0.020;
  private static final double MAX_SPEED_M_PER_S = 0.150;
  private static final double MIN_FORCE_N = 20;
  private static final double MAX_FORCE_N = 235;

  /** The travel of the activation, and the automatic release. */
  private static final double ACTIVATION_M_PER_S = 0.100;

  private static final double RELEASE_M_PER_S = 0.020;

  /** How long fingers press until they are said to hold something. */
  static final double SETTLE_S = 0.05;

  /** What the fingers are at, {@code gOBJ}. */
  public enum Contact {
    MOVING,
    MET_OPENING,
    MET_CLOSING,
    AT_POSITION
  }

  /** Trouble, {@code gFLT}. */
  public enum Fault {
    NONE(0),
    /** Asked to move while it is activated; it does afterwards. */
    ACTIVATION_RUNS(5),
    /** Asked to move before it was activated. */
    NOT_ACTIVATED(7),
    RELEASE_RUNS(11),
    RELEASE_OVER(15);

    private final int number;

    Fault(int number) {
      this.number = number;
    }

    /** The number of the register. */
    public int number() {
      return number;
    }
  }

  private enum Phase {
    RESET,
    OPENS_FIRST,
    CLOSES,
    OPENS_AGAIN,
    READY,
    RELEASES,
    RELEASED
  }

  private final Fingers fingers = new Fingers(STROKE_M);
  private final String name;
  private final Consumer<String> tell;
  private Phase phase = Phase.RESET;
  private boolean goes;
  private boolean releaseOpens;
  private int position;
  private int speed = MAX;
  private int force = MAX;
  private Contact contact = Contact.AT_POSITION;
  private Fault fault = Fault.NONE;

  /**
   * A gripper with open fingers.
   *
   * @param name its own, for what it tells
   * @param activated whether it was activated and told to go before, as an installation does
   * @param tell is told what a user wants to know
   */
  public AdaptiveGripper(String name, boolean activated, Consumer<String> tell) {
    this.name = name;
    this.tell = tell;
    if (activated) {
      phase = Phase.READY;
      goes = true;
    }
  }

  /** What it is called. */
  String name() {
    return name;
  }

  /** Its fingers. */
  public Fingers fingers() {
    return fingers;
  }

  /** Activates it, {@code rACT}, or resets it, which also ends its faults. */
  public void activate(boolean on) {
    if (!on) {
      phase = Phase.RESET;
      fault = Fault.NONE;
      contact = Contact.MOVING;
      fingers.stop();
    } else if (phase == Phase.RESET) {
      phase = Phase.OPENS_FIRST;
      fault = Fault.NONE;
      contact = Contact.MOVING;
      fingers.drive(STROKE_M, ACTIVATION_M_PER_S, MIN_FORCE_N);
    }
  }

  /** Has it go to the position that was asked for, {@code rGTO}, or stop where it is. */
  public void go(boolean on) {
    goes = on;
    if (on) {
      follow();
    } else if (phase == Phase.READY) {
      fingers.stop();
    }
  }

  /** Asks for a position, {@code rPR}; it goes there when it is told to go. */
  public void request(int number) {
    position = number;
    if (goes) {
      follow();
    }
  }

  /** How fast it goes from now on, {@code rSP}. */
  public void setSpeed(int number) {
    speed = number;
  }

  /** How hard it presses from now on, {@code rFR}. */
  public void setForce(int number) {
    force = number;
  }

  /** Which way an automatic release goes, {@code rARD}. */
  public void setReleaseOpens(boolean opens) {
    releaseOpens = opens;
  }

  /** Releases slowly and needs to be activated again, {@code rATR}. */
  public void release() {
    if (phase == Phase.RESET || phase == Phase.RELEASES || phase == Phase.RELEASED) {
      return;
    }
    phase = Phase.RELEASES;
    fault = Fault.RELEASE_RUNS;
    tell.accept(text("releasesItself", name));
    fingers.drive(releaseOpens ? STROKE_M : 0, RELEASE_M_PER_S, MIN_FORCE_N);
  }

  private void follow() {
    switch (phase) {
      case RESET -> fault(Fault.NOT_ACTIVATED, "notActivated");
      case OPENS_FIRST, CLOSES, OPENS_AGAIN -> fault = Fault.ACTIVATION_RUNS;
      case READY -> {
        fingers.drive(openingM(position), speedMPerS(speed), forceN(force));
        if (fingers.direction() == 0) {
          contact = Contact.AT_POSITION;
        } else if (!fingers.pressing()) {
          contact = Contact.MOVING;
        }
      }
      case RELEASES, RELEASED -> {}
    }
  }

  private void fault(Fault what, String key) {
    if (fault != what) {
      fault = what;
      tell.accept(text(key, name, what.number()));
    }
  }

  /** Whether it is activated, or is being so. */
  public boolean active() {
    return phase != Phase.RESET;
  }

  /** Whether it has been told to go. */
  public boolean goes() {
    return goes;
  }

  /** {@code gSTA}: 0 reset or released, 1 being activated, 3 activated. */
  public int status() {
    return switch (phase) {
      case RESET, RELEASES, RELEASED -> 0;
      case OPENS_FIRST, CLOSES, OPENS_AGAIN -> 1;
      case READY -> 3;
    };
  }

  /** What the fingers are at. */
  public Contact contact() {
    return contact;
  }

  /** Whether it holds a part. */
  public boolean holds() {
    return contact == Contact.MET_CLOSING || contact == Contact.MET_OPENING;
  }

  /** Trouble. */
  public Fault fault() {
    return fault;
  }

  /** The position that was asked for last. */
  public int requested() {
    return position;
  }

  /** Where the fingers are. */
  public int position() {
    return (int) Math.round(CLOSED - fingers.openingM() / STROKE_M * (CLOSED - OPEN));
  }

  /** The speed that was asked for. */
  public int speed() {
    return speed;
  }

  /** The force that was asked for. */
  public int force() {
    return force;
  }

  /** Whether a release goes towards open. */
  public boolean releaseOpens() {
    return releaseOpens;
  }

  /** Whether an automatic release was asked for and not ended by a reset. */
  public boolean released() {
    return phase == Phase.RELEASES || phase == Phase.RELEASED;
  }

  /** Moves it through one frame. */
  public void step() {
    fingers.step();
    boolean moves = fingers.direction() != 0 && !fingers.pressing();
    switch (phase) {
      case RESET, RELEASED -> {}
      case OPENS_FIRST -> next(!moves, Phase.CLOSES, 0);
      case CLOSES -> next(!moves, Phase.OPENS_AGAIN, STROKE_M);
      case OPENS_AGAIN -> {
        if (!moves) {
          becomeReady();
        }
      }
      case READY -> look();
      case RELEASES -> {
        if (!moves) {
          phase = Phase.RELEASED;
          fault = Fault.RELEASE_OVER;
        }
      }
    }
  }

  private void next(boolean over, Phase then, double toM) {
    if (over) {
      phase = then;
      fingers.drive(toM, ACTIVATION_M_PER_S, MIN_FORCE_N);
    }
  }

  private void becomeReady() {
    phase = Phase.READY;
    fault = Fault.NONE;
    contact = Contact.AT_POSITION;
    tell.accept(text("activated", name));
    if (goes) {
      follow();
    } else {
      fingers.stop();
    }
  }

  private void look() {
    if (!goes) {
      return;
    }
    Contact before = contact;
    if (fingers.direction() == 0) {
      contact = Contact.AT_POSITION;
    } else if (!fingers.pressing()) {
      contact = Contact.MOVING;
    } else if (fingers.pressedS() >= SETTLE_S) {
      contact = fingers.direction() < 0 ? Contact.MET_CLOSING : Contact.MET_OPENING;
    }
    if (contact != before) {
      tellOf(before);
    }
  }

  private void tellOf(Contact before) {
    if (holds()) {
      tell.accept(gripping(name, fingers));
    } else if (before == Contact.MET_CLOSING || before == Contact.MET_OPENING) {
      tell.accept(text("partLost", name));
    }
  }

  /** What fingers hold, for people. */
  static String gripping(String name, Fingers fingers) {
    return text(
        fingers.direction() > 0 ? "grippedFromInside" : "gripped",
        name,
        Math.round(1e4 * fingers.openingM()) / 10.0,
        Math.round(fingers.pressN()));
  }

  /** The opening that a position asks for, m; the stops are at its ends. */
  static double openingM(int position) {
    return STROKE_M * Math.clamp((double) (CLOSED - position) / (CLOSED - OPEN), 0, 1);
  }

  static double speedMPerS(int number) {
    return MIN_SPEED_M_PER_S + (MAX_SPEED_M_PER_S - MIN_SPEED_M_PER_S) * number / MAX;
  }

  static double forceN(int number) {
    return MIN_FORCE_N + (MAX_FORCE_N - MIN_FORCE_N) * number / MAX;
  }
}
