package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.HierarchyEvent;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;
import org.pendant.kit.layout.SettledPanel;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Move view: the screen that moves the arm by hand. */
public final class MoveView implements View {
  private final Workbench workbench;
  private final MovePresenter presenter;
  private final JPanel content = new SettledPanel(new BorderLayout());
  private final Consumer<String> insertWaypoint;

  /** Made when people first look at them. */
  private Optional<MoveCards> cards = Optional.empty();

  /** The frames that an installation offers, by name. */
  private Map<String, Pose> offered = Map.of();

  private String robotId;

  /** A screen that shows no goals in 3D and copies waypoints instead of inserting them. */
  public MoveView(Workbench workbench) {
    this(workbench, GhostArm.NONE, text -> copy(workbench, text));
  }

  /**
   * A screen; {@link #refresh} brings the arm.
   *
   * @param ghost shows the goal that the user types
   * @param insertWaypoint puts a line of URScript into the program that is edited
   */
  public MoveView(Workbench workbench, GhostArm ghost, Consumer<String> insertWaypoint) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    robotId = workbench.session().options().robotId();
    presenter =
        new MovePresenter(
            workbench.session()::submit,
            EventQueue::invokeLater,
            workbench.settings(),
            workbench.session().options().arm(),
            workbench.session()::safety,
            ghost);
    this.insertWaypoint = insertWaypoint;
    content.setName("move-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.addHierarchyListener(this::hidden);
    declareActions(workbench.actions());
    declareMoves(workbench.actions());
  }

  private void declareActions(Actions actions) {
    actions.add(
        Action.of(
            "move.copy-pose",
            text("copyTcpPoseAsUrscript"),
            "",
            () -> copy(workbench, PositionText.of(now().arm().targetTcpInBase()))));
    actions.add(
        Action.of(
            "move.copy-joints",
            text("copyJointPositionsAsUrscript"),
            "",
            () -> copy(workbench, PositionText.of(now().arm().targetPositionRad()))));
    actions.add(
        Action.of(
            "move.insert-waypoint",
            text("insertMoveToWhereTheArm"),
            "",
            () ->
                insertWaypoint.accept(
                    "movej(" + PositionText.of(now().arm().targetPositionRad()) + ")")));
  }

  private void declareMoves(Actions actions) {
    for (JogSize each : JogSize.values()) {
      actions.add(
          Action.of(
                  "move.step-" + each.name().toLowerCase(Locale.ROOT),
                  each.action(),
                  "",
                  () -> presenter.jog().setSize(each))
              .chosen(() -> presenter.jog().size() == each));
    }
    for (JogAxes each : JogAxes.values()) {
      actions.add(
          Action.of(
                  "move.axes-" + each.name().toLowerCase(Locale.ROOT),
                  text("moveByHandAlongTheAxes", each.meaning()),
                  "",
                  () -> presenter.jog().setAxes(each))
              .chosen(() -> presenter.jog().axes() == each));
    }
    actions.add(
        Action.of("move.freedrive", text("freedrive"), "", this::switchFreedrive)
            .checked(() -> presenter.freedrive().on()));
    actions.add(Action.of("move.home-here", text("setHomeToHere"), "", presenter::setHomeHere));
    actions.add(
        Action.of("move.frame-here", text("setTheFrameForMovesTo"), "", presenter::setFrameHere));
  }

  private void switchFreedrive() {
    if (presenter.freedrive().on()) {
      presenter.freedrive().release();
    } else {
      workbench.show(id());
      presenter.freedrive().begin();
    }
  }

  private ControllerState now() {
    return workbench.session().state();
  }

  private static void copy(Workbench workbench, String text) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
    workbench.notify(text("copied", text));
  }

  private MoveCards cards() {
    if (cards.isEmpty()) {
      MoveCards made = new MoveCards(presenter, text -> copy(workbench, text), insertWaypoint);
      made.offer(offered);
      content.add(made.teaching(), BorderLayout.NORTH);
      content.add(made.sheet(), BorderLayout.CENTER);
      content.add(made.obstacle(), BorderLayout.SOUTH);
      cards = Optional.of(made);
    }
    return cards.get();
  }

  /** A button that is not shown cannot be held, and a goal without its numbers says nothing. */
  private void hidden(HierarchyEvent event) {
    if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0 && !content.isShowing()) {
      presenter.jog().release();
      presenter.freedrive().release();
      presenter.goals().hide();
    }
  }

  /** Forgets the goal that was typed: the arm is moved by something else. */
  public void discardGoal() {
    presenter.goals().discard();
  }

  /**
   * Comes to the front to have the arm moved somewhere.
   *
   * @param what is taught, such as {@code Waypoint_1}
   * @param accepted runs when people say that the arm is there
   * @param left runs when they do not want to any more
   */
  public void teach(String what, Runnable accepted, Runnable left) {
    workbench.show(id());
    cards().teach(what, accepted, left);
  }

  /** Goes by an installation: its home, its TCPs, and its features as frames to move along. */
  public void setInstallation(Installation installation) {
    presenter.home().follow(installation.homeRad());
    Map<String, Pose> tools = new LinkedHashMap<>();
    installation.tools().forEach(each -> tools.put(each.name(), each.inFlange()));
    presenter.tool().named().install(tools);
    Map<String, Pose> frames = new LinkedHashMap<>();
    for (Feature each : installation.features()) {
      if (each.joggable()) {
        FeaturePoses.pose(each).ifPresent(pose -> frames.put(each.name(), pose));
      }
    }
    offered = frames;
    cards.ifPresent(each -> each.offer(frames));
  }

  /** Tells {@code listener} of each home that is set here. */
  public void whenHomeSet(Consumer<Joints> listener) {
    presenter.home().whenSet(listener);
  }

  @Override
  public String id() {
    return "move";
  }

  @Override
  public String title() {
    return text("move");
  }

  @Override
  public JComponent component() {
    var _ = cards();
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    followRobot();
    presenter.take(state, workbench.session().pace());
    cards().refresh();
  }

  private void followRobot() {
    String now = workbench.session().options().robotId();
    if (!now.equals(robotId)) {
      robotId = now;
      presenter.setArm(workbench.session().options().arm());
    }
  }
}
