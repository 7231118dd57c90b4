package org.pendant.gui.move;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.HierarchyEvent;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.layout.CardSheet;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.Actions;
import org.pendant.gui.workbench.View;
import org.pendant.gui.workbench.Workbench;
import org.pendant.models.arm.ArmLibrary;

/** The screen that moves the arm by hand. */
public final class MoveView implements View {
  private static final int GAP = 16;
  private static final int WIDEST_CARD = 520;

  private final Workbench workbench;
  private final MovePresenter presenter;
  private final JPanel content = new JPanel(new BorderLayout());
  private final ObstacleBar obstacle;
  private final JogCard jog;
  private final JointsCard joints;
  private final PoseCard pose;
  private final ToolCard tool;
  private String robotId;

  /** A screen that shows no goals in 3D and copies waypoints instead of inserting them. */
  public MoveView(Workbench workbench) {
    this(workbench, GhostArm.NONE, text -> copy(workbench, text));
  }

  /**
   * A screen; {@link #refresh} brings the arm.
   *
   * @param ghost shows the goal that somebody types
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
            ArmLibrary.load(robotId),
            ghost);
    Consumer<String> copy = text -> copy(workbench, text);
    obstacle = new ObstacleBar(presenter);
    jog = new JogCard(presenter);
    joints = new JointsCard(presenter, copy, insertWaypoint);
    pose = new PoseCard(presenter, copy, insertWaypoint);
    tool = new ToolCard(presenter);
    content.setName("move-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(obstacle, BorderLayout.NORTH);
    content.add(cards(), BorderLayout.CENTER);
    content.addHierarchyListener(this::hidden);
    declareActions(workbench.actions(), copy, insertWaypoint);
  }

  private void declareActions(
      Actions actions, Consumer<String> copy, Consumer<String> insertWaypoint) {
    actions.add(
        Action.of(
            "move.copy-pose",
            "Copy TCP pose as URScript",
            "",
            () -> copy.accept(ScriptText.of(now().arm().targetTcpInBase()))));
    actions.add(
        Action.of(
            "move.copy-joints",
            "Copy joint positions as URScript",
            "",
            () -> copy.accept(ScriptText.of(now().arm().targetPositionRad()))));
    actions.add(
        Action.of(
            "move.insert-waypoint",
            "Insert move to where the arm is",
            "",
            () ->
                insertWaypoint.accept(
                    "movej(" + ScriptText.of(now().arm().targetPositionRad()) + ")")));
  }

  private ControllerState now() {
    return workbench.session().state();
  }

  private static void copy(Workbench workbench, String text) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
    workbench.notify("Copied " + text);
  }

  private JScrollPane cards() {
    JPanel sheet = new CardSheet(GAP, WIDEST_CARD);
    sheet.add(stack(jog.component(), pose.component()));
    sheet.add(stack(joints.component(), tool.component()));
    JScrollPane scroll =
        new JScrollPane(
            sheet,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.setName("move-scroll");
    return scroll;
  }

  /** Cards that stay below each other when one grows: nothing moves under a hand that holds. */
  private static JComponent stack(JComponent upper, JComponent lower) {
    JPanel stack = new JPanel(new MigLayout("insets 0, gap 0 16, wrap", "[grow, fill]"));
    stack.setOpaque(false);
    stack.add(upper);
    stack.add(lower);
    return stack;
  }

  /** Nobody holds what they do not see. */
  private void hidden(HierarchyEvent event) {
    if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0 && !content.isShowing()) {
      presenter.release();
    }
  }

  @Override
  public String id() {
    return "move";
  }

  @Override
  public String title() {
    return "Move";
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    followRobot();
    presenter.take(state, workbench.session().pace());
    obstacle.refresh();
    jog.refresh();
    joints.refresh();
    pose.refresh();
    tool.refresh();
  }

  private void followRobot() {
    String now = workbench.session().options().robotId();
    if (!now.equals(robotId)) {
      robotId = now;
      presenter.setArm(ArmLibrary.load(robotId));
    }
  }
}
