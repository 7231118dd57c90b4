package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.settings.Settings;
import org.pendant.models.pose.Pose;

/**
 * Jog presenter: moves by button: how fast, along whose axes, held or by steps. One thread uses it.
 */
final class JogPresenter {
  private static final String SPEED = "move.speed";
  private static final int STANDARD_PERCENT = 50;

  private final JogHold hold;
  private final StepJog steps;
  private final Settings settings;
  private final IntFunction<JointRange> ranges;
  private Optional<ControllerState> state = Optional.empty();
  private Pose frameInBase = Pose.ZERO;
  private JogAxes axes = JogAxes.BASE;
  private JogSize size = JogSize.HELD;
  private PoseForm form;
  private double speedFraction;
  private boolean movable;
  private String remark = "";

  /**
   * Nothing is held.
   *
   * @param hold carries moves out
   * @param settings remembers the speed
   * @param form steps are round numbers of its units
   * @param ranges of the joints, 0 to 5
   */
  JogPresenter(JogHold hold, Settings settings, PoseForm form, IntFunction<JointRange> ranges) {
    this.hold = hold;
    this.settings = settings;
    this.form = form;
    this.ranges = ranges;
    steps = new StepJog(hold);
    speedFraction =
        settings.get(SPEED).flatMap(JogPresenter::percent).orElse(STANDARD_PERCENT) / 100.0;
  }

  private static Optional<Integer> percent(String text) {
    return text.matches("\\d{1,3}")
        ? Optional.of(Math.clamp(Integer.parseInt(text), 1, 100))
        : Optional.empty();
  }

  /** Takes the newest snapshot, and repeats what is held; about 30 times a second. */
  void take(ControllerState newest, boolean mayMove) {
    state = Optional.of(newest);
    movable = mayMove;
    if (mayMove) {
      steps.take(newest);
      hold.repeat();
    } else {
      release();
    }
  }

  /** Whether buttons that move the arm can be pressed. */
  boolean movable() {
    return movable;
  }

  /** A button that turns a joint (0 to 5) up (1) or down (-1) is pressed. */
  void turn(int joint, int direction) {
    if (size == JogSize.HELD) {
      go(new JogMove.TurnJoint(joint, direction));
    } else if (movable) {
      double after = steps.after(joint, direction, step(), now().arm().targetPositionRad());
      if (ranges.apply(joint).contains(after)) {
        remark = "";
        steps.turn(joint, direction, step(), now().arm().targetPositionRad(), speedFraction);
      } else {
        remark = text("jointAtTheEnd", JointNames.of(joint));
      }
    }
  }

  /** A button that moves or turns the tool is pressed. */
  void move(JogDirection direction) {
    if (size == JogSize.HELD) {
      go(new JogMove.MoveTool(direction, jogFrame()));
    } else if (movable) {
      remark = "";
      Pose tcp = now().arm().targetTcpInBase();
      steps.move(direction, step(), axesInBase(tcp), tcp, speedFraction);
    }
  }

  private JogFrame jogFrame() {
    return switch (axes) {
      case BASE -> JogFrame.BASE;
      case TOOL -> JogFrame.TOOL;
      case FRAME -> new JogFrame.Given(frameInBase);
    };
  }

  private Pose axesInBase(Pose tcpInBase) {
    return switch (axes) {
      case BASE -> Pose.ZERO;
      case TOOL -> tcpInBase;
      case FRAME -> frameInBase;
    };
  }

  private ControllerState now() {
    return state.orElseThrow();
  }

  /** A button is held that moves the arm as far as this says, whatever the size of steps. */
  void go(JogMove move) {
    if (movable) {
      remark = "";
      if (steps.underWay()) {
        steps.stop();
      }
      hold.press(move, speedFraction);
    }
  }

  /** A button is let go: the arm comes to rest, except on its way to the end of a step. */
  void letGo() {
    if (!steps.underWay()) {
      hold.release();
    }
  }

  /** Whatever moves comes to rest. */
  void release() {
    steps.stop();
  }

  /** Why the arm did not do what was asked last, or not any further; empty if it did. */
  String reason() {
    return remark.isEmpty() ? hold.reason() : remark;
  }

  /**
   * Changes the speed of moves that begin from now on; see {@link
   * org.pendant.controller.Command.Jog}.
   */
  void setSpeedFraction(double fraction) {
    speedFraction = fraction;
    settings.put(SPEED, Long.toString(Math.round(100 * fraction)));
  }

  double speedFraction() {
    return speedFraction;
  }

  /** Along whose axes the tool moves from now on. */
  void setAxes(JogAxes wanted) {
    release();
    axes = wanted;
  }

  JogAxes axes() {
    return axes;
  }

  /** What {@link JogAxes#FRAME} is from now on. */
  void setFrame(Pose inBase) {
    if (!inBase.equals(frameInBase)) {
      release();
      frameInBase = inBase;
    }
  }

  /** How far the arm goes at a press from now on. */
  void setSize(JogSize wanted) {
    release();
    size = wanted;
  }

  JogSize size() {
    return size;
  }

  private JogStep step() {
    return size.step(form);
  }

  /** Steps are round numbers of other units from now on. */
  void setForm(PoseForm other) {
    form = other;
  }

  PoseForm form() {
    return form;
  }
}
