package org.pendant.desktop.shell.run;

import static org.pendant.desktop.shell.run.RunTexts.text;

import java.awt.Color;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.Robot;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;

/** Messages panel: a card with the last messages. */
final class MessagesPanel {
  private final RecentMessages messages = new RecentMessages();
  private final JPanel card =
      new Card(new MigLayout("insets 16, gap 8 4, wrap 2", "[right][grow, fill]", ""));
  private final JLabel heading = new JLabel(text("messages"));

  MessagesPanel() {
    card.setName("run-messages");
    heading.putClientProperty("FlatLaf.styleClass", "h4");
    fill();
  }

  JPanel component() {
    return card;
  }

  /**
   * Shows the newest messages of a snapshot.
   *
   * @param recorded the log of a recording that the snapshot is of; empty for that of the robot
   */
  void refresh(ControllerState state, Robot robot, Optional<List<LogEntry>> recorded) {
    Object whose = recorded.<Object>map(log -> log).orElse(robot);
    boolean others =
        messages.take(
            whose,
            state.newestEntry(),
            number ->
                recorded.map(log -> after(log, number)).orElseGet(() -> robot.logSince(number)));
    if (others) {
      fill();
    }
  }

  private static List<LogEntry> after(List<LogEntry> log, long number) {
    return log.stream().filter(entry -> entry.number() > number).toList();
  }

  private void fill() {
    card.removeAll();
    card.add(heading, "span 2, alignx left");
    if (messages.messages().isEmpty()) {
      JLabel none = new JLabel(text("whatProgramsAndTheControllerSay"));
      none.setForeground(Palette.quiet());
      card.add(none, "span 2, alignx left");
    }
    for (RecentMessages.Message each : messages.messages()) {
      JLabel time = new JLabel(each.time());
      time.putClientProperty("FlatLaf.styleClass", "monospaced");
      time.setForeground(Palette.quiet());
      JLabel text = new JLabel(each.line());
      text.setToolTipText(each.whole());
      text.setForeground(color(each.level()));
      card.add(time);
      card.add(text, "wmin 0");
    }
    card.revalidate();
    card.repaint();
  }

  private Color color(LogEntry.Level level) {
    return switch (level) {
      case INFO -> heading.getForeground();
      case WARNING -> Palette.warning();
      case ERROR -> Palette.error();
    };
  }
}
