package org.pendant.gui.log;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/** One message in full, wrapped and selectable. */
final class LogDetail {
  private final JPanel content = new JPanel(new BorderLayout());
  private final JLabel heading = new JLabel();
  private final JButton source = new JButton();
  private final JTextArea text = new JTextArea();
  private Optional<LogLine> shown = Optional.empty();

  LogDetail(Consumer<LogLine> showSource) {
    JPanel head = new JPanel(new MigLayout("insets 4 8 4 8, gap 8", "[grow][]", "[28!]"));
    head.add(heading);
    head.add(source, "hidemode 3");
    heading.setForeground(LogColors.quiet());
    source.setName("log-show-source");
    source.putClientProperty("JButton.buttonType", "toolBarButton");
    source.addActionListener(event -> shown.ifPresent(showSource));
    text.setName("log-detail");
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setMargin(new Insets(0, 8, 8, 8));
    text.setToolTipText("The whole message");
    text.getAccessibleContext().setAccessibleName("The whole message");
    JScrollPane scroll = new JScrollPane(text);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    content.add(head, BorderLayout.NORTH);
    content.add(scroll, BorderLayout.CENTER);
    content.setMinimumSize(new Dimension(0, 0));
    showNone();
  }

  JComponent component() {
    return content;
  }

  void show(LogLine line) {
    if (shown.isPresent() && shown.get().equals(line)) {
      return;
    }
    shown = Optional.of(line);
    heading.setText(
        String.format(
            Locale.ROOT, "%s from %s at %.3f s", line.severity(), line.source(), line.timeS()));
    heading.setIcon(new SeverityIcon(line.level()));
    Font code = UIManager.getFont("monospaced.font");
    text.setFont(code == null ? text.getFont() : code);
    text.setText(line.text());
    text.setCaretPosition(0);
    source.setVisible(line.sourceLine().isPresent());
    line.sourceLine().ifPresent(this::offerSource);
  }

  private void offerSource(int line) {
    source.setText("Go to line " + line);
    source.setToolTipText("Show line " + line + " of the program (Enter in the list)");
    source.getAccessibleContext().setAccessibleName(source.getText());
  }

  void showNone() {
    shown = Optional.empty();
    heading.setText("Select a message to read all of it");
    heading.setIcon(null);
    text.setText("");
    source.setVisible(false);
  }

  void copy(String words) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(words), null);
  }
}
