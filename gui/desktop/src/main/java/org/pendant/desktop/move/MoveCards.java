package org.pendant.desktop.move;

import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.CardColumns;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.WideContent;
import org.pendant.models.pose.Pose;

/** Move cards: everything that people see and touch on the Move screen. */
final class MoveCards {
  private static final int GAP = 16;
  private static final int WIDEST_CARD = 520;

  private final ObstacleBar obstacle;
  private final TeachBar teaching = new TeachBar();
  private final JogCard jog;
  private final FreedriveCard freedrive;
  private final JointsCard joints;
  private final PoseCard pose;
  private final HomeCard home;
  private final FrameCard frame;
  private final TcpCard tcp;
  private final PayloadCard payload;

  /**
   * Cards of what a presenter knows.
   *
   * @param copy puts a text on the clipboard
   * @param insertWaypoint puts a line of URScript into the program that is edited
   */
  MoveCards(MovePresenter presenter, Consumer<String> copy, Consumer<String> insertWaypoint) {
    obstacle = new ObstacleBar(presenter);
    jog = new JogCard(presenter.jog());
    freedrive = new FreedriveCard(presenter.freedrive());
    joints = new JointsCard(presenter, copy, insertWaypoint);
    pose = new PoseCard(presenter, copy, insertWaypoint);
    home = new HomeCard(presenter);
    frame = new FrameCard(presenter);
    tcp = new TcpCard(presenter);
    payload = new PayloadCard(presenter.tool());
  }

  /** What is taught. */
  JComponent teaching() {
    return teaching;
  }

  /** What hinders moves: below the cards, as it comes and goes while people look at them. */
  JComponent obstacle() {
    return obstacle;
  }

  /** The cards, which scroll. */
  JScrollPane sheet() {
    JPanel sheet = new WideContent(new CardColumns(GAP, WIDEST_CARD));
    sheet.add(stack(jog.component(), joints.component()));
    sheet.add(stack(pose.component(), frame.component(), home.component()));
    sheet.add(stack(freedrive.component(), tcp.component(), payload.component()));
    JScrollPane scroll = new SettledScroll(sheet);
    scroll.setName("move-scroll");
    return scroll;
  }

  /** Cards that stay below each other when one grows: nothing moves under a hand that holds. */
  private static JComponent stack(JComponent... cards) {
    JPanel stack =
        new JPanel(new MigLayout("insets 0, gap 0 16, wrap, hidemode 3", "[grow, fill]"));
    stack.setOpaque(false);
    for (JComponent each : cards) {
      stack.add(each);
    }
    return stack;
  }

  /** Asks people to move the arm, see {@link MoveView#teach}. */
  void teach(String what, Runnable accepted, Runnable left) {
    teaching.ask(what, accepted, left);
  }

  /** Offers frames to move along, by name. */
  void offer(Map<String, Pose> frames) {
    frame.offer(frames);
  }

  /** Shows what the presenter knows now. */
  void refresh() {
    obstacle.refresh();
    jog.refresh();
    freedrive.refresh();
    joints.refresh();
    pose.refresh();
    home.refresh();
    frame.refresh();
    tcp.refresh();
    payload.refresh();
  }
}
